#pragma once

#include <algorithm>
#include <bit>
#include <span>
#include <vector>

#include "core/atomic.hpp"
#include "core/image.hpp"
#include "surface/region_statistics.hpp"

namespace facet {

/// Statistics of components where these are: at their first pixels, which name them.
struct RegionField {
  ImageView<const std::int32_t> root;
  ImageView<RegionStatistics> statistics;

  FACET_HD bool names(int x, int y) const { return root(x, y) == y * root.width + x; }
  FACET_HD RegionStatistics& of(std::int32_t first) const {
    return statistics(first % root.width, first / root.width);
  }
};

struct ClearRegionOp {
  static constexpr int radius = 0;
  RegionField field;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    if (field.names(x, y)) field.statistics(x, y) = {0, y * field.root.width + x, 0, 0, 0};
  }
};

/// Adds each run of a row to its component, from the run's first pixel on.
struct AddRunOp {
  static constexpr int radius = 0;
  RegionField field;
  ImageView<const float> depth_m;
  ImageView<const std::uint8_t> filled;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    const std::int32_t first = field.root(x, y);
    if (first < 0 || (x > 0 && field.root(x - 1, y) == first)) return;
    int end = x, filled_px = 0;
    for (; end < field.root.width && field.root(end, y) == first; ++end) filled_px += filled(end, y) != 0;
    RegionStatistics& sums = field.of(first);
    fetch_add(&sums.area_px, end - x);
    if (filled_px > 0) fetch_add(&sums.filled_px, filled_px);
    fetch_add(&sums.twice_depth,
              RegionStatistics::twice_depth_of_run(end - x, depth_m(x, y), depth_m(end - 1, y)));
  }
};

/// Lists the components in any order, from place 1 on; place 0 holds their number as its area. Those that
/// find no place are only counted.
struct ListRegionOp {
  static constexpr int radius = 0;
  RegionField field;
  ImageView<RegionStatistics> list;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    if (!field.names(x, y)) return;
    RegionStatistics& here = field.statistics(x, y);
    here.place = fetch_add(&list(0, 0).area_px, 1) + 1;
    if (here.place < list.width) list(here.place, 0) = here;
  }
};

/// Gives every pixel the label of its component.
struct LabelRegionOp {
  static constexpr int radius = 0;
  RegionField field;
  ImageView<const std::uint16_t> label_at;  ///< by place
  ImageView<std::uint16_t> label;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    const std::int32_t first = field.root(x, y);
    label(x, y) = first < 0 ? std::uint16_t{0} : label_at(field.of(first).place, 0);
  }
};

/// Numbers components where they are, on the executor's side: the host sees one line per component instead of
/// the images. Keeps its memory between frames.
template <template <class> class ImageOf>
class RegionTable {
 public:
  /// root, depth_m and filled are as RegionNumbering::number() takes them, and so is `label`. choose(list)
  /// gets the components in raster order of their first pixels and returns the label of each.
  template <class Executor, class Choose>
  void number(Executor& executor, ImageView<const std::int32_t> root, ImageView<const float> depth_m,
              ImageView<const std::uint8_t> filled, ImageView<std::uint16_t> label, const Choose& choose) {
    statistics_.resize(root.size());
    if (list_.size().empty()) list_.resize({least_places, 1});
    const RegionField field{root, statistics_.view()};
    executor.for_each_pixel(root.size(), ClearRegionOp{field});
    executor.for_each_pixel(root.size(), AddRunOp{field, depth_m, filled});
    read_list(executor, field);
    write_labels(executor, choose(std::span<const RegionStatistics>(sorted_)));
    executor.for_each_pixel(root.size(), LabelRegionOp{field, label_at_.view(), label});
  }

 private:
  static constexpr int least_places = 1024;

  /// Twice where there are more of them than places.
  template <class Executor>
  void read_list(Executor& executor, const RegionField& field) {
    int count = list(executor, field);
    const int needed =
        std::max(least_places, static_cast<int>(std::bit_ceil(static_cast<unsigned>(count) + 1)));
    if (needed > list_.size().width) {
      list_.resize({needed, 1});
      count = list(executor, field);
    }
    const RegionStatistics* found = executor.on_host(list_).row(0) + 1;
    sorted_.assign(found, found + count);
    const auto comes_first = [](const auto& a, const auto& b) { return a.first < b.first; };
    std::sort(sorted_.begin(), sorted_.end(), comes_first);
    if (4 * needed < list_.size().width) list_.resize({needed, 1});  // the frames before had far more
  }
  template <class Executor>
  int list(Executor& executor, const RegionField& field) {
    const ImageView<RegionStatistics> all = list_.view();
    executor.fill(ImageView<RegionStatistics>{all.data, 1, 1, 1}, RegionStatistics{});
    executor.for_each_pixel(field.root.size(), ListRegionOp{field, all});
    return executor.on_host(list_)(0, 0).area_px;
  }
  template <class Executor>
  void write_labels(Executor& executor, std::span<const std::uint16_t> labels) {
    label_at_.resize(list_.size());
    host_label_at_.resize(list_.size());
    for (std::size_t i = 0; i < sorted_.size(); ++i) host_label_at_(sorted_[i].place, 0) = labels[i];
    executor.upload(ImageView<const std::uint16_t>(host_label_at_.view()), label_at_.view());
  }

  ImageOf<RegionStatistics> statistics_, list_;
  ImageOf<std::uint16_t> label_at_;
  Image<std::uint16_t> host_label_at_;
  std::vector<RegionStatistics> sorted_;
};

}  // namespace facet
