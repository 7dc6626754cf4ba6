#include "cpu/tuned/pruning.hpp"

#include <limits>

#include "core/clones.hpp"
#include "cpu/pack_bits.hpp"

namespace facet {
namespace {

FACET_CPU_CLONES void mark_measured(const float* depth_m, int width, std::uint8_t* measured) {
  for (int x = 0; x < width; ++x) measured[x] = depth_m[x] > 0;
}

/// Finds the open ends from a word of the lines on; returns their words all together. What is not measured is
/// a wall.
FACET_CPU_CLONES std::uint64_t find_open_ends(const std::uint64_t* line, const std::uint64_t* measured,
                                              std::ptrdiff_t pitch, std::ptrdiff_t count,
                                              std::uint64_t* ends) {
  std::uint64_t any = 0;
#pragma GCC ivdep
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    const auto neighbours = neighbours_of(line - pitch + k, line + k, line + pitch + k);
    auto walls = neighbours_of(measured - pitch + k, measured + k, measured + pitch + k);
    FACET_UNROLL for (int i = 0; i < 8; ++i) walls.p[i] = ~walls.p[i] | neighbours.p[i];
    ends[k] = line[k] & is_open_end(neighbours, walls);
    any |= ends[k];
  }
  return any;
}
bool find_open_ends(const BitMask& line, const BitMask& measured, int first, int behind, BitMask& ends) {
  return find_open_ends(line.row(first) - 1, measured.row(first) - 1, line.pitch(),
                        (behind - first) * line.pitch(), ends.row(first) - 1) != 0;
}

/// Removes open ends `passes` times, or until there are none.
void remove_open_ends(int passes, const BitMask& measured, DueBlocks& due, BitMask& line, BitMask& ends) {
  const auto find = [&](int first, int behind) {
    return find_open_ends(line, measured, first, behind, ends);
  };
  const auto remove = [&](int first, int behind) { subtract(line, ends, first, behind); };
  for (int pass = 0; pass < passes; ++pass)
    if (!due.pass(0, find, remove)) break;
}

}  // namespace

void prune(CpuExecutor& executor, const PruningParams& params, ImageView<const float> depth_m,
           ImageView<std::uint8_t> edge, const PruningScratch&) {
  if (params.mode == PruningMode::none) return;
  CpuScratch& scratch = executor.scratch();
  auto& [line, measured, ends, original] = scratch.bits;
  pack(executor, edge, line);
  pack_rows(executor, depth_m.size(), measured,
            [&](int y, std::uint8_t* bytes) { mark_measured(depth_m.row(y), depth_m.width, bytes); });
  ends.resize(line.size());
  original = line;
  scratch.due_blocks.reset(edge.height);
  const bool to_stability = params.mode == PruningMode::stability;
  remove_open_ends(to_stability ? std::numeric_limits<int>::max() : params.iterations, measured,
                   scratch.due_blocks, line, ends);
  if (!to_stability) {  // grow the ends that are left back along the original
    find_open_ends(line, measured, 0, edge.height, ends);
    BitMask& spare = measured;
    for (int i = 0; i < params.iterations; ++i) {
      dilate_square(1, ends, spare);
      intersect(ends, original);
    }
    unite(line, ends);
  }
  unpack(executor, line, edge);
}

}  // namespace facet
