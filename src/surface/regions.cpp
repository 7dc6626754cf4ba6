#include "surface/regions.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

#include "core/run.hpp"

namespace facet {
namespace {

/// visit(value, y, begin, end) for every run of equal pixels in a row, in raster order.
template <class T, class Visit>
void for_each_run(ImageView<const T> image, const Visit& visit) {
  for (int y = 0; y < image.height; ++y) {
    const T* row = image.row(y);
    for (int x = 0; x < image.width;) {
      const int begin = x;
      x = end_of_run(row, begin + 1, image.width, row[begin]);
      visit(row[begin], y, begin, x);
    }
  }
}

/// How many of the ones and zeros between the ends are ones; eight at a time.
int count_ones(const std::uint8_t* begin, const std::uint8_t* end) {
  int count = 0;
  for (; end - begin >= 8; begin += 8) {
    std::uint64_t word;
    std::memcpy(&word, begin, sizeof word);
    if (word != 0) count += static_cast<int>(word * 0x0101010101010101u >> 56);
  }
  for (; begin != end; ++begin) count += *begin;
  return count;
}

std::string_view reason_to_drop(const RegionStatistics& c, const Camera& camera,
                                const ValidationParams& validation) {
  if (static_cast<float>(c.area_px) < least_area_px(validation, camera, c.mean_depth_m()))
    return reject_reason::too_small;
  const float measured = static_cast<float>(c.area_px - c.filled_px) / static_cast<float>(c.area_px);
  if (validation.enabled && measured < validation.min_valid_share) return reject_reason::missing_depth;
  return {};
}

}  // namespace

void RegionNumbering::collect(ImageView<const std::int32_t> root, ImageView<const float> depth_m,
                              ImageView<const std::uint8_t> filled) {
  components_.clear();
  runs_.clear();
  component_at_.resize(static_cast<std::size_t>(root.size().area()));
  for_each_run(root, [&](std::int32_t first, int y, int begin, int end) {
    if (first < 0) return;
    std::int32_t& index = component_at_[static_cast<std::size_t>(first)];
    if (first == y * root.width + begin) {  // in raster order it comes before the others
      index = static_cast<std::int32_t>(components_.size());
      components_.emplace_back().first = first;
    }
    runs_.push_back({static_cast<std::size_t>(index), y, begin, end});
    RegionStatistics& component = components_[static_cast<std::size_t>(index)];
    component.area_px += end - begin;
    component.filled_px += count_ones(filled.row(y) + begin, filled.row(y) + end);
    component.twice_depth +=
        RegionStatistics::twice_depth_of_run(end - begin, depth_m(begin, y), depth_m(end - 1, y));
  });
}

int RegionNumbering::choose(std::span<const RegionStatistics> components, int width_px, const Camera& camera,
                            const ValidationParams& validation, std::vector<RejectedRegion>& rejected) {
  constexpr int most = std::numeric_limits<std::uint16_t>::max();
  int count = 0;
  label_.assign(components.size(), 0);
  for (std::size_t i = 0; i < components.size(); ++i) {
    const RegionStatistics& c = components[i];
    std::string_view reason = reason_to_drop(c, camera, validation);
    if (reason.empty() && count == most) reason = reject_reason::too_many;
    if (reason.empty())
      label_[i] = static_cast<std::uint16_t>(++count);
    else
      rejected.push_back({{c.first % width_px, c.first / width_px}, c.area_px, std::string(reason)});
  }
  return count;
}

int RegionNumbering::number(ImageView<const std::int32_t> root, ImageView<const float> depth_m,
                            ImageView<const std::uint8_t> filled, const Camera& camera,
                            const ValidationParams& validation, ImageView<std::uint16_t> labels,
                            std::vector<RejectedRegion>& rejected) {
  collect(root, depth_m, filled);
  const int count = choose(components_, root.width, camera, validation, rejected);
  write_labels(labels);
  return count;
}

void RegionNumbering::write_labels(ImageView<std::uint16_t> labels) const {
  auto run = runs_.begin();
  for (int y = 0; y < labels.height; ++y) {
    std::uint16_t* at = labels.row(y);
    for (; run != runs_.end() && run->y == y; ++run) {
      at = std::fill_n(at, labels.row(y) + run->begin - at, std::uint16_t{0});
      at = std::fill_n(at, run->end - run->begin, label_[run->component]);
    }
    std::fill_n(at, labels.row(y) + labels.width - at, std::uint16_t{0});
  }
}

void RegionPixels::collect(ImageView<const std::uint16_t> labels, int label_count,
                           ImageView<const float> depth_m, ImageView<const std::uint8_t> filled,
                           const Camera& camera, int max_points) {
  const auto n = static_cast<std::size_t>(label_count);
  boxes.assign(n, {});
  area_px.assign(n, 0);
  measured_px.assign(n, 0);
  runs_.clear();
  for_each_run(labels, [&](std::uint16_t label, int y, int begin, int end) {
    if (label == 0) return;
    const std::size_t i = label - std::size_t{1};
    const int made_up = count_ones(filled.row(y) + begin, filled.row(y) + end);
    runs_.push_back({i, y, begin, end});
    boxes[i].add(begin, y);
    boxes[i].add(end - 1, y);
    area_px[i] += end - begin;
    measured_px[i] += end - begin - made_up;
  });
  sample_points(depth_m, filled, camera, max_points);
}

void RegionPixels::sample_points(ImageView<const float> depth_m, ImageView<const std::uint8_t> filled,
                                 const Camera& camera, int max_points) {
  if (points.size() < area_px.size()) points.resize(area_px.size());
  // Every stride-th measured pixel in raster order; an odd stride does not fall into step with the columns.
  stride_.resize(area_px.size());
  for (std::size_t i = 0; i < area_px.size(); ++i)
    stride_[i] = (measured_px[i] + max_points - 1) / max_points | 1;
  for (std::size_t i = 0; i < area_px.size(); ++i)
    points[i].resize(static_cast<std::size_t>((measured_px[i] + stride_[i] - 1) / stride_[i]));
  taken_.assign(area_px.size(), 0);
  wait_.assign(area_px.size(), 0);  // measured pixels until the next sample
  for (const Run& run : runs_) {
    const std::uint8_t* made_up = filled.row(run.y);
    for (int x = run.begin; x < run.end;) {
      const int end = end_of_run<std::uint8_t>(made_up, x, run.end, 0);
      sample_run(run.region, run.y, x, end, depth_m.row(run.y), camera);
      x = end_of_run<std::uint8_t>(made_up, end, run.end, 1);
    }
  }
}

void RegionPixels::sample_run(std::size_t region, int y, int begin, int end, const float* depth_m,
                              const Camera& shared_camera) {
  const Camera camera = shared_camera;
  const int stride = stride_[region];
  const int first = begin + wait_[region];
  const int count = first < end ? (end - first + stride - 1) / stride : 0;
  PointSample& sample = points[region];
  const std::size_t taken = taken_[region];
  float *__restrict px = sample.x.data() + taken, *__restrict py = sample.y.data() + taken,
                   *__restrict pz = sample.z.data() + taken;
  for (int i = 0; i < count; ++i) {
    const int x = first + i * stride;
    const Vec3 p = camera.back_project(static_cast<float>(x), static_cast<float>(y), depth_m[x]);
    px[i] = p.x, py[i] = p.y, pz[i] = p.z;
  }
  taken_[region] = taken + static_cast<std::size_t>(count);
  wait_[region] = first + count * stride - end;
}

}  // namespace facet
