#include "surface/regions.hpp"

#include <algorithm>
#include <limits>

namespace facet {

void RegionNumbering::collect(ImageView<const std::int32_t> root, ImageView<const float> depth_m,
                              ImageView<const std::uint8_t> filled) {
  components_.clear();
  component_at_.assign(static_cast<std::size_t>(root.size().area()), -1);
  for (int y = 0; y < root.height; ++y)
    for (int x = 0; x < root.width; ++x) {
      const std::int32_t first = root(x, y);
      if (first < 0) continue;
      std::int32_t& index = component_at_[static_cast<std::size_t>(first)];
      if (index < 0) {
        index = static_cast<std::int32_t>(components_.size());
        components_.push_back({first, 0, 0, 0});
      }
      Component& component = components_[static_cast<std::size_t>(index)];
      ++component.area_px;
      component.filled_px += filled(x, y);
      component.depth_sum_m += depth_m(x, y);
    }
}

std::string_view RegionNumbering::reason_to_drop(const Component& c, const Camera& camera,
                                                 const ValidationParams& validation) const {
  const auto mean_depth_m = static_cast<float>(c.depth_sum_m / c.area_px);
  if (static_cast<float>(c.area_px) < least_area_px(validation, camera, mean_depth_m))
    return reject_reason::too_small;
  const float measured = static_cast<float>(c.area_px - c.filled_px) / static_cast<float>(c.area_px);
  if (validation.enabled && measured < validation.min_valid_share) return reject_reason::missing_depth;
  return {};
}

int RegionNumbering::number(ImageView<const std::int32_t> root, ImageView<const float> depth_m,
                            ImageView<const std::uint8_t> filled, const Camera& camera,
                            const ValidationParams& validation, ImageView<std::uint16_t> labels,
                            std::vector<RejectedRegion>& rejected) {
  collect(root, depth_m, filled);
  constexpr int most = std::numeric_limits<std::uint16_t>::max();
  int count = 0;
  label_.assign(components_.size(), 0);
  for (std::size_t i = 0; i < components_.size(); ++i) {
    const Component& c = components_[i];
    std::string_view reason = reason_to_drop(c, camera, validation);
    if (reason.empty() && count == most) reason = reject_reason::too_many;
    if (reason.empty())
      label_[i] = static_cast<std::uint16_t>(++count);
    else
      rejected.push_back({{c.first % root.width, c.first / root.width}, c.area_px, std::string(reason)});
  }
  for (int y = 0; y < root.height; ++y)
    for (int x = 0; x < root.width; ++x) {
      const std::int32_t first = root(x, y);
      labels(x, y) = first < 0
                         ? std::uint16_t{0}
                         : label_[static_cast<std::size_t>(component_at_[static_cast<std::size_t>(first)])];
    }
  return count;
}

void RegionPixels::collect(ImageView<const std::uint16_t> labels, int label_count,
                           ImageView<const float> depth_m, ImageView<const std::uint8_t> filled,
                           const Camera& camera, int max_points) {
  const auto n = static_cast<std::size_t>(label_count);
  boxes.assign(n, {});
  area_px.assign(n, 0);
  measured_px.assign(n, 0);
  if (points.size() < n) points.resize(n);
  for (PointSample& sample : points) sample.clear();
  for (int y = 0; y < labels.height; ++y)
    for (int x = 0; x < labels.width;) {
      const std::uint16_t label = labels(x, y);
      const int begin = x;
      int measured = 0;
      for (; x < labels.width && labels(x, y) == label; ++x) measured += !filled(x, y);
      if (label == 0) continue;
      const std::size_t i = label - std::size_t{1};
      boxes[i].add(begin, y);
      boxes[i].add(x - 1, y);
      area_px[i] += x - begin;
      measured_px[i] += measured;
    }
  // Every stride-th measured pixel in raster order; an odd stride does not fall into step with the columns.
  seen_.assign(n, 0);
  for (int y = 0; y < labels.height; ++y)
    for (int x = 0; x < labels.width; ++x) {
      if (labels(x, y) == 0 || filled(x, y)) continue;
      const std::size_t i = labels(x, y) - std::size_t{1};
      const int stride = (measured_px[i] + max_points - 1) / max_points | 1;
      if (seen_[i]++ % stride != 0) continue;
      points[i].add(camera.back_project(static_cast<float>(x), static_cast<float>(y), depth_m(x, y)));
    }
}

}  // namespace facet
