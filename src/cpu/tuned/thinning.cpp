#include "cpu/tuned/thinning.hpp"

#include "core/clones.hpp"
#include "cpu/pack_bits.hpp"
#include "stage/thinning.hpp"

namespace facet {
namespace {

/// Finds the pixels that one sub-iteration deletes, from `row` on; returns their words all together.
template <int half>
FACET_CPU_CLONES std::uint64_t find_doomed(const std::uint64_t* row, std::ptrdiff_t pitch,
                                           std::ptrdiff_t count, std::uint64_t* doomed) {
  std::uint64_t any = 0;
#pragma GCC ivdep
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    doomed[k] = row[k] & guo_hall_deletes(neighbours_of(row - pitch + k, row + k, row + pitch + k), half);
    any |= doomed[k];
  }
  return any;
}

template <int half>
bool thin_once(BitMask& mask, DueBlocks& due, BitMask& doomed) {
  const auto find = [&](int first, int behind) {
    return find_doomed<half>(mask.row(first) - 1, mask.pitch(), (behind - first) * mask.pitch(),
                             doomed.row(first) - 1) != 0;
  };
  const auto remove = [&](int first, int behind) { subtract(mask, doomed, first, behind); };
  return due.pass(half, find, remove);
}

}  // namespace

void thin(CpuExecutor& executor, ImageView<std::uint8_t> edge, ImageView<std::uint8_t>) {
  CpuScratch& scratch = executor.scratch();
  BitMask &mask = scratch.bits[0], &doomed = scratch.bits[1];
  pack(executor, edge, mask);
  doomed.resize(mask.size());
  scratch.due_blocks.reset(edge.height);
  bool changed = true;
  while (changed) {
    changed = thin_once<0>(mask, scratch.due_blocks, doomed);
    changed |= thin_once<1>(mask, scratch.due_blocks, doomed);
  }
  unpack(executor, mask, edge);
}

}  // namespace facet
