#include "surface/basin_merging.hpp"

#include <algorithm>
#include <utility>

#include "core/angle.hpp"

namespace facet {
namespace {

/// Basins of fewer independent readings than this may be noise.
constexpr double min_readings = 5;
/// Where no strength is known, that few readings tell no crease: a patch of them is what its prior says.
constexpr double blind_readings = 1.5;
/// Slope of a surface, dz/dx, that is not unusual: 63 degrees to the image plane.
constexpr double usual_slope = 2;
/// A sum of six squares of standard normal numbers, one per term of a patch, is larger in one case of 100.
constexpr double chi_square_6_99 = 16.8;

}  // namespace

/// Variance of q of one independent reading, times the pixels that share one.
double BasinMerging::reading_variance(const PatchMoments& moments) const {
  const double q = moments.mean_q();  // noise of q = noise of z times q^2
  const double sigma = noise_.sigma_m(static_cast<float>(1 / q)) * q * q;
  return double{noise_.pixels_per_reading} * sigma * sigma;
}

PatchFit BasinMerging::fitted(const PatchMoments& moments) const {
  // A surface of radius R has dq/dx = q/f times its slope dz/dx, and d2q/dx2 = 1 / (R f^2).
  const double curvature =
      params_.curve_radius_mm > 0 ? 1e3 / (params_.curve_radius_mm * focal_px_ * focal_px_) : 1e-12;
  return moments.fit({reading_variance(moments), usual_slope * moments.mean_q() / focal_px_, curvature});
}

/// Whether a border is longer or a side larger than when it was judged.
bool BasinMerging::has_changed(int i) {
  const BasinBorder& border = graph_.border(i);
  const Judgement& judged = judgements_[static_cast<std::size_t>(i)];
  return border.length != judged.length ||
         graph_.moments(graph_.find(border.a)).count() + graph_.moments(graph_.find(border.b)).count() !=
             judged.pixels;
}

bool BasinMerging::judge(int i) {
  const BasinBorder& border = graph_.border(i);
  const int a = graph_.find(border.a), b = graph_.find(border.b);
  Judgement& judged = judgements_[static_cast<std::size_t>(i)];
  judged = {graph_.moments(a).count() + graph_.moments(b).count(), border.length, judged.serial + 1};
  if (border.strength() > most_strength_) return false;
  const auto [excess, expected] =
      seam_difference(fits_[static_cast<std::size_t>(a)], fits_[static_cast<std::size_t>(b)], border.seam,
                      focal_px_, tolerance_);
  if (excess >= 1) return false;
  candidates_.push_back({static_cast<float>(expected), i, judged.serial});
  return true;
}

void BasinMerging::judge_anew(int i) {
  if (judge(i)) std::push_heap(candidates_.begin(), candidates_.end(), is_later);
}

/// Whether the patch fitted to both regions explains them as well as two do: what it adds to the squares is
/// noise or, over the smaller region, within the tolerated step.
bool BasinMerging::explains_both(const PatchFit& fit, const PatchMoments& both, int a, int b) const {
  const double added = fit.squares() - fits_[static_cast<std::size_t>(a)].squares() -
                       fits_[static_cast<std::size_t>(b)].squares();
  const double fewer_px = std::min(graph_.moments(a).count(), graph_.moments(b).count());
  const double step = double{params_.step_ratio} * both.mean_q();
  return added < chi_square_6_99 * reading_variance(both) + fewer_px * step * step;
}

bool BasinMerging::join_across(int i) {
  const int a = graph_.find(graph_.border(i).a), b = graph_.find(graph_.border(i).b);
  PatchMoments both = graph_.moments(a);
  both += graph_.moments(b);
  const PatchFit fit = fitted(both);
  if (!explains_both(fit, both, a, b)) return false;
  // Other borders of the larger one are judged anew when their turn comes.
  const std::span<const int> touched = graph_.join(a, b);
  fits_[static_cast<std::size_t>(graph_.find(a))] = fit;
  for (const int k : touched) judge_anew(k);
  return true;
}

bool BasinMerging::join_alike(float most_strength) {
  bool joined = false;
  most_strength_ = most_strength;
  candidates_.clear();
  for (std::size_t i = 0; i < judgements_.size(); ++i)
    if (graph_.border(static_cast<int>(i)).length > 0) judge(static_cast<int>(i));
  std::make_heap(candidates_.begin(), candidates_.end(), is_later);
  while (!candidates_.empty()) {
    std::pop_heap(candidates_.begin(), candidates_.end(), is_later);
    const Candidate best = candidates_.back();
    candidates_.pop_back();
    const bool is_gone = graph_.border(best.border).length == 0;
    if (is_gone || best.serial != judgements_[static_cast<std::size_t>(best.border)].serial) continue;
    if (has_changed(best.border))
      judge_anew(best.border);
    else
      joined |= join_across(best.border);
  }
  return joined;
}

void BasinMerging::merge(const BasinLandscape& landscape, const MergeParams& params, const DepthNoise& noise,
                         Image<std::int32_t>& region) {
  params_ = params;
  tolerance_ = {params.crease_deg / static_cast<double>(degrees_per_radian), params.step_ratio,
                params.fit_sigmas};
  noise_ = noise;
  focal_px_ = static_cast<double>(landscape.camera.fx);
  const double px = double{noise.pixels_per_reading};
  const int count = shallow_.join(
      landscape,
      {min_readings * px, blind_readings * px, double{params.step_ratio}, double{params.fit_sigmas}, noise},
      region, contacts_);
  graph_.build(landscape, std::as_const(region).view(), count, contacts_);
  fits_.resize(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) fits_[static_cast<std::size_t>(i)] = fitted(graph_.moments(i));
  judgements_.assign(graph_.borders().size(), {});
  join_alike(chord_of(params.flat_deg));
  while (join_alike(unknown_strength)) {
  }
  first_of_.resize(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) first_of_[static_cast<std::size_t>(i)] = graph_.find(i);
  for (int y = 0; y < region.height(); ++y)
    for (int x = 0; x < region.width(); ++x)
      if (region(x, y) >= 0) region(x, y) = first_of_[static_cast<std::size_t>(region(x, y))];
  competition_.run({landscape, fits_, noise, double{params.fit_sigmas}}, params.border_moves_px,
                   region.view());
}

}  // namespace facet
