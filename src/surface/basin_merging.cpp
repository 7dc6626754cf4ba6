#include "surface/basin_merging.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/angle.hpp"

namespace facet {
namespace {

/// Pixels per independent reading: sensors correlate the noise of neighbouring pixels (block matching
/// windows).
constexpr double pixels_per_reading = 20;
/// Basins of fewer independent readings than this may be noise.
constexpr double min_readings = 5;
/// Slope of a surface, dz/dx, that is not unusual: 63 degrees to the image plane.
constexpr double usual_slope = 2;

/// Crease strength of an angle.
float chord_of(float deg) {
  return 2 * std::sin(deg / 2 / degrees_per_radian);
}

}  // namespace

/// The topographic dynamics of a basin: how high its lowest pass is above its bottom.
void BasinMerging::join_shallow_basins(float floor) {
  auto& borders = graph_.borders();
  std::sort(borders.begin(), borders.end(), [](const BasinBorder& l, const BasinBorder& r) {
    return std::tie(l.lowest, l.a, l.b) < std::tie(r.lowest, r.a, r.b);
  });
  for (const BasinBorder& border : borders) {
    const int a = graph_.find(border.a), b = graph_.find(border.b);
    if (a == b || border.lowest >= unknown_strength) continue;
    const Basin &l = graph_.basin(a), &r = graph_.basin(b);
    const bool few = std::min(l.moments.count(), r.moments.count()) <= min_readings * pixels_per_reading;
    if (few && border.lowest - std::max(l.lowest, r.lowest) < floor)
      graph_.join(std::min(a, b), std::max(a, b));
  }
}

void BasinMerging::fit(int i) {
  const PatchMoments& moments = graph_.basin(i).moments;
  const double q = moments.mean_q();  // noise of q = noise of z times q^2
  const double sigma = noise_.sigma_m(static_cast<float>(1 / q)) * q * q;
  // A surface of radius R has dq/dx = q/f times its slope dz/dx, and d2q/dx2 = 1 / (R f^2).
  const double curvature =
      params_.curve_radius_mm > 0 ? 1e3 / (params_.curve_radius_mm * focal_px_ * focal_px_) : 1e-12;
  fits_[static_cast<std::size_t>(i)] =
      moments.fit({pixels_per_reading * sigma * sigma, usual_slope * q / focal_px_, curvature});
}

bool BasinMerging::merge_round(float most_strength) {
  graph_.update_borders();
  const SeamTolerance tolerance{params_.crease_deg / static_cast<double>(degrees_per_radian),
                                params_.step_ratio, params_.fit_sigmas};
  candidates_.clear();
  for (const BasinBorder& border : graph_.borders()) {
    if (border.strength() > most_strength) continue;
    const double difference =
        seam_difference(fits_[static_cast<std::size_t>(border.a)], fits_[static_cast<std::size_t>(border.b)],
                        border.seam(), focal_px_, tolerance);
    if (difference < 1) candidates_.push_back({static_cast<float>(difference), border.a, border.b});
  }
  std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& l, const Candidate& r) {
    return std::tie(l.difference, l.a, l.b) < std::tie(r.difference, r.a, r.b);
  });
  ++round_;
  for (const auto& [difference, a, b] : candidates_) {
    int &round_a = joined_in_[static_cast<std::size_t>(a)],
        &round_b = joined_in_[static_cast<std::size_t>(b)];
    const bool changed = round_a == round_ || round_b == round_;
    round_a = round_b = round_;  // a region whose best neighbour has changed waits for the next round
    if (changed) continue;
    graph_.join(a, b);
    fit(a);
  }
  return !candidates_.empty();
}

void BasinMerging::merge(const BasinLandscape& landscape, const MergeParams& params, const DepthNoise& noise,
                         Image<std::int32_t>& region) {
  params_ = params;
  noise_ = noise;
  focal_px_ = static_cast<double>(landscape.camera.fx);
  round_ = 0;
  graph_.build(landscape);
  join_shallow_basins(landscape.floor);
  fits_.resize(static_cast<std::size_t>(graph_.basin_count()));
  joined_in_.assign(fits_.size(), 0);
  for (int i = 0; i < graph_.basin_count(); ++i)
    if (graph_.find(i) == i) fit(i);
  for (const float most_strength : {chord_of(params.flat_deg), unknown_strength})
    while (merge_round(most_strength)) {
    }
  region.resize(landscape.basin.size());
  graph_.write_regions(landscape, region.view());
}

}  // namespace facet
