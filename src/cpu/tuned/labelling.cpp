#include "cpu/tuned/labelling.hpp"

#include <algorithm>

#include "core/clones.hpp"
#include "core/run.hpp"

namespace facet {
namespace {

/// Runs of region pixels, row by row: start and end column, and the parent run in a union-find forest. Runs
/// are numbered in raster order, so the smallest run of a set holds its first pixel.
class RunForest {
 public:
  RunForest(std::vector<int>& begin, std::vector<int>& end, DisjointSets& sets)
      : begin_(begin), end_(end), sets_(sets) {
    begin_.clear(), end_.clear(), sets_.reset(0);
  }
  int count() const { return static_cast<int>(begin_.size()); }
  int begin(int run) const { return begin_[static_cast<std::size_t>(run)]; }
  int end(int run) const { return end_[static_cast<std::size_t>(run)]; }
  void add(int begin, int end) {
    begin_.push_back(begin);
    end_.push_back(end);
    sets_.add();
  }
  int find(int run) { return sets_.find(run); }
  void unite(int a, int b) { sets_.join(a, b); }

 private:
  std::vector<int>&begin_, &end_;
  DisjointSets& sets_;
};

FACET_CPU_CLONES void mark_regions(const float* depth_m, const std::uint8_t* edge, int width,
                                   std::uint8_t* region) {
  for (int x = 0; x < width; ++x) region[x] = (depth_m[x] > 0) & (edge[x] == 0);
}

void add_runs(const std::uint8_t* region, int width, RunForest& runs) {
  for (int x = end_of_run<std::uint8_t>(region, 0, width, 0); x < width;) {
    const int end = end_of_run<std::uint8_t>(region, x, width, 1);
    runs.add(x, end);
    x = end_of_run<std::uint8_t>(region, end, width, 0);
  }
}

/// Joins runs of two neighbouring rows, [above, row) and [row, end), that share a column.
void join_rows(RunForest& runs, int above, int row) {
  const int end = runs.count();
  int a = above;
  for (int r = row; r < end; ++r) {
    while (a < row && runs.end(a) <= runs.begin(r)) ++a;
    for (int k = a; k < row && runs.begin(k) < runs.end(r); ++k) runs.unite(k, r);
  }
}

}  // namespace

void label_components(CpuExecutor& executor, ImageView<const float> depth_m,
                      ImageView<const std::uint8_t> edge, ImageView<std::int32_t> root) {
  CpuScratch& scratch = executor.scratch();
  RunForest runs(scratch.list_a, scratch.list_b, scratch.sets);
  std::vector<int>& row_starts = scratch.row_starts;
  row_starts.assign(1, 0);
  std::vector<std::uint8_t>& region = scratch.row;
  region.resize(static_cast<std::size_t>(root.width));
  for (int y = 0; y < root.height; ++y) {
    mark_regions(depth_m.row(y), edge.row(y), root.width, region.data());
    add_runs(region.data(), root.width, runs);
    if (y > 0) join_rows(runs, row_starts[static_cast<std::size_t>(y) - 1], row_starts.back());
    row_starts.push_back(runs.count());
  }
  // Raster index of the first pixel of every run's set; sets are named by their first run.
  std::vector<int>& name = scratch.names;
  name.resize(static_cast<std::size_t>(runs.count()));
  for (int y = 0; y < root.height; ++y) {
    std::int32_t* at = root.row(y);
    for (int r = row_starts[static_cast<std::size_t>(y)]; r < row_starts[static_cast<std::size_t>(y) + 1];
         ++r) {
      const int first = runs.find(r);
      if (first == r) name[static_cast<std::size_t>(r)] = y * root.width + runs.begin(r);
      at = std::fill_n(at, root.row(y) + runs.begin(r) - at, -1);
      at = std::fill_n(at, runs.end(r) - runs.begin(r), name[static_cast<std::size_t>(first)]);
    }
    std::fill_n(at, root.row(y) + root.width - at, -1);
  }
}

}  // namespace facet
