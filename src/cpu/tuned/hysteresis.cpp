#include "cpu/tuned/hysteresis.hpp"

#include <utility>

#include "core/clones.hpp"
#include "cpu/pack_bits.hpp"
#include "stage/ridge.hpp"

namespace facet {
namespace {

FACET_CPU_CLONES void mark_any(const std::uint8_t* ridge, int width, std::uint8_t* mark) {
  for (int x = 0; x < width; ++x) mark[x] = ridge[x] != 0;
}
FACET_CPU_CLONES void mark_strong(const std::uint8_t* ridge, int width, std::uint8_t* mark) {
  for (int x = 0; x < width; ++x) mark[x] = ridge[x] == static_cast<std::uint8_t>(Ridge::strong);
}

/// Grows the seeds along runs of the ridge, to the end of the word in both directions.
std::uint64_t grow_in_word(std::uint64_t seed, std::uint64_t ridge) {
  // Upwards an addition carries through each run; downwards the seeds spread by doubling steps.
  std::uint64_t grown = seed | (ridge & ~(ridge + seed) & ~seed);
  std::uint64_t open = ridge;
  for (int step = 1; step < 64; step *= 2) {
    grown |= open & grown >> step;
    open &= open >> step;
  }
  return grown & ridge;
}

/// Spreads the edges of the rows above and below, and those of the row itself, along the row's ridges.
/// Returns whether the row gained any.
bool grow_row(const std::uint64_t* above, const std::uint64_t* below, const std::uint64_t* ridge, int words,
              std::uint64_t* edge) {
  std::uint64_t gained = 0;
  const auto grow = [&](int k) {
    const auto beside = [k](const std::uint64_t* row) {
      return row[k] | row[k] << 1 | row[k - 1] >> 63 | row[k] >> 1 | row[k + 1] << 63;
    };
    const std::uint64_t seed = (beside(above) | beside(edge) | beside(below)) & ridge[k];
    if (seed == edge[k]) return;
    const std::uint64_t grown = grow_in_word(seed, ridge[k]);
    gained |= grown ^ edge[k];
    edge[k] = grown;
  };
  for (int k = 0; k < words; ++k) grow(k);
  for (int k = words - 1; k >= 0; --k) grow(k);
  return gained != 0;
}

/// Sweeps down and up until nothing changes; a row is looked at again when one beside it has gained.
void grow_edges(const BitMask& ridge, std::vector<std::uint8_t>& due, BitMask& edge) {
  const int height = edge.size().height;
  due.assign(static_cast<std::size_t>(height) + 2, 1);  // a row more on either side
  bool changed = true;
  const auto visit = [&](int y) {
    const auto row = static_cast<std::size_t>(y) + 1;
    if (!std::exchange(due[row], 0)) return;
    if (!grow_row(edge.row(y - 1), edge.row(y + 1), ridge.row(y), edge.words(), edge.row(y))) return;
    due[row - 1] = due[row] = due[row + 1] = 1;
    changed = true;
  };
  while (changed) {
    changed = false;
    for (int y = 0; y < height; ++y) visit(y);
    for (int y = height - 1; y >= 0; --y) visit(y);
  }
}

}  // namespace

void hysteresis(CpuExecutor& executor, ImageView<std::uint8_t> ridge, ImageView<std::uint8_t> edge) {
  BitMask &any = executor.scratch().bits[0], &strong = executor.scratch().bits[1];
  pack_rows(executor, ridge.size(), any,
            [&](int y, std::uint8_t* bytes) { mark_any(ridge.row(y), ridge.width, bytes); });
  pack_rows(executor, ridge.size(), strong,
            [&](int y, std::uint8_t* bytes) { mark_strong(ridge.row(y), ridge.width, bytes); });
  grow_edges(any, executor.scratch().rows_due, strong);
  unpack(executor, strong, edge);
}

}  // namespace facet
