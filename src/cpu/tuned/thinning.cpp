#include "cpu/tuned/thinning.hpp"

#include "core/clones.hpp"
#include "stage/thinning.hpp"

namespace facet {
namespace {

/// One sub-iteration on a row; returns the pixels deleted, of all words together.
template <int half>
FACET_CPU_CLONES std::uint64_t thin_row(const std::uint64_t* above, const std::uint64_t* row,
                                        const std::uint64_t* below, int words, std::uint64_t* out) {
  std::uint64_t deleted = 0;
  for (int k = 0; k < words; ++k) {
    const std::uint64_t doomed =
        row[k] & guo_hall_deletes(neighbours_of(above + k, row + k, below + k), half);
    out[k] = row[k] & ~doomed;
    deleted |= doomed;
  }
  return deleted;
}

template <int half>
bool thin_once(BitMask& mask, BitMask& spare) {
  std::uint64_t deleted = 0;
  for (int y = 0; y < mask.size().height; ++y)
    deleted |= thin_row<half>(mask.row(y - 1), mask.row(y), mask.row(y + 1), mask.words(), spare.row(y));
  mask.swap(spare);
  return deleted != 0;
}

}  // namespace

void thin(CpuExecutor& executor, ImageView<std::uint8_t> edge, ImageView<std::uint8_t>) {
  BitMask &mask = executor.scratch().bits[0], &spare = executor.scratch().bits[1];
  mask.assign(edge);
  spare.resize(mask.size());
  bool changed = true;
  while (changed) {
    changed = thin_once<0>(mask, spare);
    changed |= thin_once<1>(mask, spare);
  }
  mask.write(edge);
}

}  // namespace facet
