#pragma once

#include <cstdint>

#include "core/image_view.hpp"
#include "core/neighbour_rule.hpp"
#include "core/neighbour_table.hpp"
#include "stage/mask_by_table.hpp"

namespace facet {

/// Whether sub-iteration `half` (0 or 1) of Guo and Hall's parallel thinning (CACM 32(3), 1989) deletes a
/// pixel; keeps 8-connectivity and end points.
template <class Word>
constexpr Word guo_hall_deletes(const Neighbours<Word>& neighbours, int half) {
  const auto& p = neighbours.p;
  // Two ways to pair the neighbours; the smaller number of pairs that are not empty is 2 or 3.
  const Word a0 = p[7] | p[0], a1 = p[1] | p[2], a2 = p[3] | p[4], a3 = p[5] | p[6];
  const Word b0 = p[0] | p[1], b1 = p[2] | p[3], b2 = p[4] | p[5], b3 = p[6] | p[7];
  const Word two_of_a = (a0 & a1) | (a2 & a3) | ((a0 | a1) & (a2 | a3));
  const Word two_of_b = (b0 & b1) | (b2 & b3) | ((b0 | b1) & (b2 | b3));
  const Word all_pairs = a0 & a1 & a2 & a3 & b0 & b1 & b2 & b3;
  const Word blocked = half == 0 ? (p[0] | p[1] | ~p[3]) & p[2] : (p[4] | p[5] | ~p[7]) & p[6];
  return one_crossing(p) & two_of_a & two_of_b & ~all_pairs & ~blocked;
}
constexpr bool guo_hall_deletes(unsigned code, int half) {
  return (guo_hall_deletes(neighbours_of(code), half) & 1u) != 0;
}
inline constexpr NeighbourTable thinning_tables[2]{
    make_neighbour_table([](unsigned code) { return guo_hall_deletes(code, 0); }),
    make_neighbour_table([](unsigned code) { return guo_hall_deletes(code, 1); })};

/// Thins the 0/1 mask `edge` in place to lines of one pixel (I1 of paper eq. 10, first step). `mark` is
/// scratch.
template <class Executor>
void thin(Executor& executor, ImageView<std::uint8_t> edge, ImageView<std::uint8_t> mark) {
  executor.take_changed();
  do {
    for (const NeighbourTable& table : thinning_tables) {
      executor.for_each_set(edge, MarkByTableOp{table, edge, mark});
      executor.for_each_set(edge, DeleteMarkedOp{edge, mark, executor.changed_flag()});
    }
  } while (executor.take_changed());
}

}  // namespace facet
