#include "surface/basin_merging.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "core/run.hpp"

namespace facet {
namespace {

/// Pixels per independent reading: sensors correlate the noise of neighbouring pixels (block matching
/// windows).
constexpr double pixels_per_reading = 20;
/// A border known along fewer pixels than this says nothing by itself; the fits decide.
constexpr double min_known_border_px = 3;

/// Crease strength of an angle.
float chord_of(float deg) {
  return 2 * std::sin(deg / 2 / 57.29578f);
}

}  // namespace

int BasinMerging::find(int i) {
  auto at = [&](int k) -> int& { return basins_[static_cast<std::size_t>(k)].parent; };
  while (at(i) != i) i = at(i) = at(at(i));
  return i;
}

void BasinMerging::collect_basins(const BasinLandscape& l) {
  const int width = l.basin.width, height = l.basin.height;
  basins_.clear();
  index_.assign(static_cast<std::size_t>(l.basin.size().area()), -1);
  for (int y = 0; y < height; ++y)
    for (int begin = 0, end = 0; begin < width; begin = end) {
      const std::int32_t name = l.basin(begin, y);
      end = end_of_run(l.basin.row(y), begin + 1, width, name);
      if (name < 0) continue;
      std::int32_t& index = index_[static_cast<std::size_t>(name)];
      if (index < 0) {
        index = static_cast<std::int32_t>(basins_.size());
        basins_.push_back({index, name, 0, 0, 0, {}});
      }
      Basin& basin = basins_[static_cast<std::size_t>(index)];
      const std::int32_t* q = l.inverse_depth.row(y) + begin;
      basin.moments.add_run(begin - 0.5 * width, y - 0.5 * height, end - begin,
                            [&](int k) { return l.inverse_depth_unit * q[k]; });
      for (int x = begin; x < end; ++x) {
        if (l.distance_px(x, y) <= l.guard_px) continue;
        basin.strength_sum += l.strength(x, y);
        basin.strength_count += 1;
      }
    }
}

void BasinMerging::collect_borders(const BasinLandscape& l) {
  borders_.clear();
  const auto add_pair = [&](int x0, int y0, int x1, int y1) {
    const std::int32_t here = l.basin(x0, y0), there = l.basin(x1, y1);
    if (here == there || here < 0 || there < 0) return;
    const int a = index_[static_cast<std::size_t>(here)], b = index_[static_cast<std::size_t>(there)];
    const bool known = l.distance_px(x0, y0) > l.guard_px && l.distance_px(x1, y1) > l.guard_px;
    const float strength = known ? std::max(l.strength(x0, y0), l.strength(x1, y1)) : 0.0f;
    borders_.push_back({std::min(a, b), std::max(a, b), strength, known ? 1.0f : 0.0f, 0, 0});
  };
  for (int y = 0; y < l.basin.height; ++y)
    for (int x = 0; x < l.basin.width; ++x) {
      if (x + 1 < l.basin.width) add_pair(x, y, x + 1, y);
      if (y + 1 < l.basin.height) add_pair(x, y, x, y + 1);
    }
}

/// Names the sides of every border by their present regions and joins borders between the same two.
void BasinMerging::aggregate_borders() {
  int place = 0;
  for (Border& border : borders_) {
    const int a = find(border.a), b = find(border.b);
    border.a = std::min(a, b), border.b = std::max(a, b);
    border.place = place++;
  }
  // By place too: the sums are floats, their order must not depend on the sort. (A stable sort would
  // allocate.)
  std::sort(borders_.begin(), borders_.end(), [](const Border& l, const Border& r) {
    return std::tie(l.a, l.b, l.place) < std::tie(r.a, r.b, r.place);
  });
  std::size_t kept = 0;
  for (const Border& border : borders_) {
    if (border.a == border.b) continue;
    if (kept > 0 && borders_[kept - 1].a == border.a && borders_[kept - 1].b == border.b) {
      borders_[kept - 1].strength_sum += border.strength_sum;
      borders_[kept - 1].strength_count += border.strength_count;
    } else {
      borders_[kept++] = border;
    }
  }
  borders_.resize(kept);
}

float BasinMerging::rise_of(const Border& border) const {
  if (border.strength_count < min_known_border_px) return 0;
  const auto inside = [&](int i) {
    const Basin& basin = basins_[static_cast<std::size_t>(i)];
    return basin.strength_count > 0 ? static_cast<float>(basin.strength_sum / basin.strength_count) : 0.0f;
  };
  return border.strength_sum / border.strength_count - std::max(inside(border.a), inside(border.b));
}

bool BasinMerging::is_crease(const Border& border) const {
  const bool known = border.strength_count >= min_known_border_px;
  if (known && rise_of(border) < chord_of(criteria_.rise_deg)) return false;
  const bool may_be_smooth =
      known && border.strength_sum / border.strength_count < chord_of(criteria_.smooth_deg);
  return needs_two_patches(basins_[static_cast<std::size_t>(border.a)].moments,
                           basins_[static_cast<std::size_t>(border.b)].moments, may_be_smooth);
}

/// One patch has three parameters less than the two: a plane less than two planes, a quadric less than a
/// plane beside a quadric. A smooth curved surface needs no border although no plane explains it; there what
/// two patches gain must be no more than what noise gives them.
bool BasinMerging::needs_two_patches(const PatchMoments& a, const PatchMoments& b, bool may_be_smooth) const {
  PatchMoments both = a;
  both += b;
  const double q = both.mean_q();  // noise of q = noise of z times q^2
  const double sigma = noise_.sigma_m(static_cast<float>(1 / q)) * q * q;
  const double gain_of_noise = 3 * sigma * sigma * pixels_per_reading;
  const double plane_a = a.plane_residual(), plane_b = b.plane_residual();
  if (both.plane_residual() - plane_a - plane_b < criteria_.fit_ratio * gain_of_noise) return false;
  if (!may_be_smooth) return true;
  const double apart = std::min(plane_a + b.quadric_residual(), plane_b + a.quadric_residual());
  return both.quadric_residual() - apart >= gain_of_noise;
}

bool BasinMerging::merge_round() {
  aggregate_borders();
  for (Border& border : borders_) border.rise = rise_of(border);
  std::sort(borders_.begin(), borders_.end(), [](const Border& l, const Border& r) {
    return std::tie(l.rise, l.a, l.b) < std::tie(r.rise, r.a, r.b);
  });
  ++round_;
  bool merged = false;
  for (const Border& border : borders_) {
    Basin& into = basins_[static_cast<std::size_t>(border.a)];
    Basin& from = basins_[static_cast<std::size_t>(border.b)];
    if (into.merged_in == round_ || from.merged_in == round_ || is_crease(border)) continue;
    from.parent = border.a;
    into.merged_in = from.merged_in = round_;
    into.name = std::min(into.name, from.name);
    into.strength_sum += from.strength_sum;
    into.strength_count += from.strength_count;
    into.moments += from.moments;
    merged = true;
  }
  return merged;
}

void BasinMerging::merge(const BasinLandscape& l, const MergeCriteria& criteria, const DepthNoise& noise,
                         Image<std::int32_t>& region) {
  criteria_ = criteria;
  noise_ = noise;
  round_ = 0;
  collect_basins(l);
  collect_borders(l);
  while (merge_round()) {
  }
  region.resize(l.basin.size());
  for (int y = 0; y < l.basin.height; ++y)
    for (int x = 0; x < l.basin.width; ++x) {
      const std::int32_t name = l.basin(x, y);
      region(x, y) =
          name < 0 ? -1
                   : basins_[static_cast<std::size_t>(find(index_[static_cast<std::size_t>(name)]))].name;
    }
}

}  // namespace facet
