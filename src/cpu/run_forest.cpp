#include "cpu/run_forest.hpp"

#include "core/clones.hpp"
#include "core/run.hpp"

namespace facet {
namespace {

FACET_CPU_CLONES void mark_regions(const float* depth_m, const std::uint8_t* edge, int width,
                                   std::uint8_t* region) {
  for (int x = 0; x < width; ++x) region[x] = (depth_m[x] > 0) & (edge[x] == 0);
}

}  // namespace

RunForest::RunForest(CpuScratch& scratch, ImageView<const float> depth_m, ImageView<const std::uint8_t> edge)
    : begin_(scratch.list_a), end_(scratch.list_b), row_starts_(scratch.row_starts), sets_(scratch.sets) {
  begin_.clear(), end_.clear(), sets_.reset(0);
  row_starts_.assign(1, 0);
  std::vector<std::uint8_t>& region = scratch.row;
  region.resize(static_cast<std::size_t>(depth_m.width));
  for (int y = 0; y < depth_m.height; ++y) {
    mark_regions(depth_m.row(y), edge.row(y), depth_m.width, region.data());
    add_runs(region.data(), depth_m.width);
    if (y > 0) join_rows(first_of_row(y - 1), first_of_row(y));
    row_starts_.push_back(count());
  }
}

void RunForest::add_runs(const std::uint8_t* region, int width) {
  for (int x = end_of_run<std::uint8_t>(region, 0, width, 0); x < width;) {
    const int end = end_of_run<std::uint8_t>(region, x, width, 1);
    begin_.push_back(x);
    end_.push_back(end);
    sets_.add();
    x = end_of_run<std::uint8_t>(region, end, width, 0);
  }
}

/// Joins runs of two neighbouring rows, [above, row) and [row, end), that share a column.
void RunForest::join_rows(int above, int row) {
  int a = above;
  for (int r = row; r < count(); ++r) {
    while (a < row && end(a) <= begin(r)) ++a;
    for (int k = a; k < row && begin(k) < end(r); ++k) sets_.join(k, r);
  }
}

}  // namespace facet
