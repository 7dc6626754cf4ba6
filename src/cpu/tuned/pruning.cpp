#include "cpu/tuned/pruning.hpp"

#include <algorithm>

#include "core/clones.hpp"

namespace facet {
namespace {

/// A row of a mask with those above and below it.
struct ThreeRows {
  const std::uint64_t *above, *row, *below;
  ThreeRows(const BitMask& mask, int y) : above(mask.row(y - 1)), row(mask.row(y)), below(mask.row(y + 1)) {}
};

FACET_CPU_CLONES void mark_measured(const float* depth_m, int width, std::uint8_t* measured) {
  for (int x = 0; x < width; ++x) measured[x] = depth_m[x] > 0;
}

/// The open ends of a row; returns the words of all of them together. What is not measured is a wall.
FACET_CPU_CLONES std::uint64_t find_open_ends(const ThreeRows& line, const ThreeRows& measured, int words,
                                              std::uint64_t* ends) {
  std::uint64_t any = 0;
  for (int k = 0; k < words; ++k) {
    const auto neighbours = neighbours_of(line.above + k, line.row + k, line.below + k);
    auto walls = neighbours_of(measured.above + k, measured.row + k, measured.below + k);
    for (int i = 0; i < 8; ++i) walls.p[i] = ~walls.p[i] | neighbours.p[i];
    ends[k] = line.row[k] & is_open_end(neighbours, walls);
    any |= ends[k];
  }
  return any;
}

/// Marks the open ends of the rows that are due, and sets which rows are due next: those beside an end.
bool find_open_ends(const BitMask& line, const BitMask& measured, std::vector<std::uint8_t>& due,
                    std::vector<std::uint8_t>& next, BitMask& ends) {
  bool any = false;
  next.assign(due.size(), 0);
  for (int y = 0; y < line.size().height; ++y) {
    const auto row = static_cast<std::size_t>(y) + 1;  // a row more on either side
    if (!due[row]) {
      std::fill_n(ends.row(y), line.words(), std::uint64_t{0});
    } else if (find_open_ends({line, y}, {measured, y}, line.words(), ends.row(y))) {
      next[row - 1] = next[row] = next[row + 1] = 1;
      any = true;
    }
  }
  return any;
}

}  // namespace

void prune(CpuExecutor& executor, const PruningParams& params, ImageView<const float> depth_m,
           ImageView<std::uint8_t> edge, const PruningScratch&) {
  if (params.mode == PruningMode::none) return;
  CpuScratch& scratch = executor.scratch();
  auto& [line, measured, ends, original] = scratch.bits;
  line.assign(edge);
  measured.assign_rows(depth_m.size(), [&](int y, std::uint8_t* bytes) {
    mark_measured(depth_m.row(y), depth_m.width, bytes);
  });
  ends.resize(line.size());
  original = line;
  std::vector<std::uint8_t>&due = scratch.rows_due, &next = scratch.rows_due_next;
  due.assign(static_cast<std::size_t>(edge.height) + 2, 1);
  const bool to_stability = params.mode == PruningMode::stability;
  for (int pass = 0; to_stability || pass < params.iterations; ++pass) {
    if (!find_open_ends(line, measured, due, next, ends)) break;
    subtract(line, ends);
    due.swap(next);
  }
  if (!to_stability) {  // grow the ends that are left back along the original
    due.assign(due.size(), 1);
    find_open_ends(line, measured, due, next, ends);
    BitMask& spare = measured;
    for (int i = 0; i < params.iterations; ++i) {
      dilate_square(1, ends, spare);
      intersect(ends, original);
    }
    unite(line, ends);
  }
  line.write(edge);
}

}  // namespace facet
