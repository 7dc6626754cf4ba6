#include "surface/regions.hpp"

#include <algorithm>
#include <limits>

#include "core/clones.hpp"
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

/// visit(run, begin, end) for every run of a row.
template <class Visit>
void for_each_run_of_row(const ComponentRuns& runs, int y, const Visit& visit) {
  const auto first = static_cast<std::size_t>(runs.first_of_row[static_cast<std::size_t>(y)]),
             behind = static_cast<std::size_t>(runs.first_of_row[static_cast<std::size_t>(y) + 1]);
  for (std::size_t run = first; run < behind; ++run) visit(run, runs.begin[run], runs.end[run]);
}

constexpr int block = 16;  ///< labels that are written at once

/// Writes a label from x to `end` and a little beyond, where the next run will write: most runs are short,
/// and how short would be guessed wrong.
void write_run(int x, int end, std::uint16_t label, std::uint16_t* row) {
  for (; x < end; x += block) std::fill_n(row + x, block, label);
}

FACET_CPU_CLONES void back_project_row(const float* ray_x, float ray_y, const float* depth_m, int count,
                                       float* x, float* y, float* z) {
#pragma GCC ivdep
  for (int i = 0; i < count; ++i) {
    x[i] = ray_x[i] * depth_m[i];
    y[i] = ray_y * depth_m[i];
    z[i] = depth_m[i];
  }
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

ComponentRuns RegionNumbering::list_runs(ImageView<const std::int32_t> root) {
  begin_.clear(), end_.clear(), first_of_component_.clear();
  first_of_row_.assign(static_cast<std::size_t>(root.height) + 1, 0);
  run_at_.resize(static_cast<std::size_t>(root.size().area()));
  for_each_run(root, [&](std::int32_t first, int y, int begin, int end) {
    if (first < 0) return;
    const int run = static_cast<int>(begin_.size());
    int& first_run = run_at_[static_cast<std::size_t>(first)];
    if (first == y * root.width + begin) first_run = run;  // in raster order it comes before the others
    begin_.push_back(begin);
    end_.push_back(end);
    first_of_component_.push_back(first_run);
    first_of_row_[static_cast<std::size_t>(y) + 1] = run + 1;
  });
  for (std::size_t y = 1; y < first_of_row_.size(); ++y)  // rows without runs
    first_of_row_[y] = std::max(first_of_row_[y], first_of_row_[y - 1]);
  return {begin_, end_, first_of_row_, first_of_component_};
}

void RegionNumbering::collect(const ComponentRuns& runs, ImageView<const float> depth_m,
                              ImageView<const std::uint8_t> filled) {
  components_.clear();
  component_of_.resize(runs.begin.size());
  for (int y = 0; y < depth_m.height; ++y)
    for_each_run_of_row(runs, y, [&](std::size_t run, int begin, int end) {
      const auto first = static_cast<std::size_t>(runs.first_of_component[run]);
      if (first == run) {
        component_of_[run] = static_cast<int>(components_.size());
        components_.emplace_back().first = y * depth_m.width + begin;
      } else {
        component_of_[run] = component_of_[first];
      }
      RegionStatistics& component = components_[static_cast<std::size_t>(component_of_[run])];
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

int RegionNumbering::number(const ComponentRuns& runs, ImageView<const float> depth_m,
                            ImageView<const std::uint8_t> filled, const Camera& camera,
                            const ValidationParams& validation, ImageView<std::uint16_t> labels,
                            std::vector<RejectedRegion>& rejected) {
  collect(runs, depth_m, filled);
  const int count = choose(components_, labels.width, camera, validation, rejected);
  write_labels(runs, labels);
  return count;
}

int RegionNumbering::number(ImageView<const std::int32_t> root, ImageView<const float> depth_m,
                            ImageView<const std::uint8_t> filled, const Camera& camera,
                            const ValidationParams& validation, ImageView<std::uint16_t> labels,
                            std::vector<RejectedRegion>& rejected) {
  return number(list_runs(root), depth_m, filled, camera, validation, labels, rejected);
}

void RegionNumbering::write_labels(const ComponentRuns& runs, ImageView<std::uint16_t> labels) {
  row_.resize(static_cast<std::size_t>(labels.width + block));
  for (int y = 0; y < labels.height; ++y) {
    int x = 0;
    for_each_run_of_row(runs, y, [&](std::size_t run, int begin, int end) {
      write_run(x, begin, 0, row_.data());
      write_run(begin, end, label_[static_cast<std::size_t>(component_of_[run])], row_.data());
      x = end;
    });
    write_run(x, labels.width, 0, row_.data());
    std::copy_n(row_.data(), labels.width, labels.row(y));
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
  // A ray times a depth is what Camera::back_project() gives, to the bit, without its quotients.
  ray_x_.resize(static_cast<std::size_t>(depth_m.width));
  for (int x = 0; x < depth_m.width; ++x)
    ray_x_[static_cast<std::size_t>(x)] = camera.back_project(static_cast<float>(x), 0, 1).x;
  for (const Run& run : runs_) {
    const std::uint8_t* made_up = filled.row(run.y);
    const float ray_y = camera.back_project(0, static_cast<float>(run.y), 1).y;
    for (int x = run.begin; x < run.end;) {
      const int end = end_of_run<std::uint8_t>(made_up, x, run.end, 0);
      sample_run(run.region, ray_y, x, end, depth_m.row(run.y));
      x = end_of_run<std::uint8_t>(made_up, end, run.end, 1);
    }
  }
}

void RegionPixels::sample_run(std::size_t region, float ray_y, int begin, int end, const float* depth_m) {
  const int stride = stride_[region];
  PointSample& sample = points[region];
  std::size_t taken = taken_[region];
  int x = begin + wait_[region];
  if (stride == 1) {
    back_project_row(ray_x_.data() + x, ray_y, depth_m + x, end - x, sample.x.data() + taken,
                     sample.y.data() + taken, sample.z.data() + taken);
    taken += static_cast<std::size_t>(end - x);
    x = end;
  }
  for (; x < end; x += stride, ++taken) {
    const float z = depth_m[x];
    sample.set(taken, {ray_x_[static_cast<std::size_t>(x)] * z, ray_y * z, z});
  }
  taken_[region] = taken;
  wait_[region] = x - end;
}

}  // namespace facet
