#pragma once

#include <span>

#include "cpu/executor.hpp"

namespace facet {

/// Runs of region pixels, measured ones that are no edge, row by row: start and end column. Runs are numbered
/// in raster order. Those of a 4-connected component are a set, named by its first run, which holds its first
/// pixel. Lies in the memory of the tuned stages, until the next is made there.
class RunForest {
 public:
  RunForest(CpuExecutor& executor, ImageView<const float> depth_m, ImageView<const std::uint8_t> edge);

  int count() const { return count_; }
  int begin(int run) const { return begin_[static_cast<std::size_t>(run)]; }
  int end(int run) const { return end_[static_cast<std::size_t>(run)]; }
  /// The first run of row y, or, where y is the height, the number of runs.
  int first_of_row(int y) const { return row_starts_[static_cast<std::size_t>(y)]; }
  int set_of(int run) { return sets_.find(run); }
  std::span<const int> begins() const { return {begin_.data(), static_cast<std::size_t>(count_)}; }
  std::span<const int> ends() const { return {end_.data(), static_cast<std::size_t>(count_)}; }
  std::span<const int> row_starts() const { return row_starts_; }  ///< and the number of runs

 private:
  void add_runs(const BitMask& regions, int y);
  void join_rows(int above, int row, int behind);

  int count_ = 0;
  std::vector<int>&begin_, &end_, &row_starts_;
  DisjointSets& sets_;
};

}  // namespace facet
