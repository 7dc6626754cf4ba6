#include "cpu/run_forest.hpp"

#include <bit>

#include "core/clones.hpp"
#include "cpu/pack_bits.hpp"

namespace facet {
namespace {

FACET_CPU_CLONES void mark_regions(const float* depth_m, const std::uint8_t* edge, int width,
                                   std::uint8_t* region) {
  for (int x = 0; x < width; ++x) region[x] = (depth_m[x] > 0) & (edge[x] == 0);
}

}  // namespace

RunForest::RunForest(CpuExecutor& executor, ImageView<const float> depth_m,
                     ImageView<const std::uint8_t> edge)
    : begin_(executor.scratch().list_a),
      end_(executor.scratch().list_b),
      row_starts_(executor.scratch().row_starts),
      sets_(executor.scratch().sets) {
  BitMask& regions = executor.scratch().bits[0];
  pack_rows(executor, depth_m.size(), regions, [&](int y, std::uint8_t* bytes) {
    mark_regions(depth_m.row(y), edge.row(y), depth_m.width, bytes);
  });
  row_starts_.assign(1, 0);
  for (int y = 0; y < depth_m.height; ++y) {
    add_runs(regions, y);
    row_starts_.push_back(count_);
  }
  sets_.reset(count_);
  for (int y = 1; y < depth_m.height; ++y)
    join_rows(first_of_row(y - 1), first_of_row(y), first_of_row(y + 1));
}

/// Bits that differ from the one before are begins and ends of runs, in turn. There are no branches but those
/// from word to word, as most runs are short.
void RunForest::add_runs(const BitMask& regions, int y) {
  const auto most = static_cast<std::size_t>(count_ + regions.size().width / 2 + 2);
  if (begin_.size() < most) begin_.resize(2 * most);
  if (end_.size() < most) end_.resize(2 * most);
  int* const places[2] = {begin_.data(), end_.data()};
  const std::uint64_t* row = regions.row(y);
  int found = 2 * count_;
  for (int k = 0; k <= regions.words(); ++k)  // the word behind the row is clear
    for (std::uint64_t changes = row[k] ^ (row[k] << 1 | row[k - 1] >> 63); changes != 0;
         changes &= changes - 1, ++found)
      places[found & 1][found >> 1] = 64 * k + std::countr_zero(changes);
  count_ = found / 2;
}

/// Joins runs of two neighbouring rows, [above, row) and [row, behind), that share a column.
void RunForest::join_rows(int above, int row, int behind) {
  int a = above;
  for (int r = row; r < behind; ++r) {
    while (a < row && end(a) <= begin(r)) ++a;
    for (int k = a; k < row && begin(k) < end(r); ++k) sets_.join(k, r);
  }
}

}  // namespace facet
