#pragma once

#include <cstdint>

#include "core/image_view.hpp"
#include "core/neighbour_table.hpp"
#include "stage/mask_by_table.hpp"

namespace facet {

/// Whether sub-iteration `half` (0 or 1) of Guo and Hall's parallel thinning (CACM 32(3), 1989) deletes a
/// pixel with this 8-neighbour code; keeps 8-connectivity and end points.
constexpr bool guo_hall_deletes(unsigned code, int half) {
  const auto p = [code](unsigned i) { return (code >> i & 1u) != 0; };  // 0 = north, clockwise
  const int crossings = (!p(0) && (p(1) || p(2))) + (!p(2) && (p(3) || p(4))) + (!p(4) && (p(5) || p(6))) +
                        (!p(6) && (p(7) || p(0)));
  const int n1 = (p(7) || p(0)) + (p(1) || p(2)) + (p(3) || p(4)) + (p(5) || p(6));
  const int n2 = (p(0) || p(1)) + (p(2) || p(3)) + (p(4) || p(5)) + (p(6) || p(7));
  const int n = n1 < n2 ? n1 : n2;
  const bool blocked = half == 0 ? (p(0) || p(1) || !p(3)) && p(2) : (p(4) || p(5) || !p(7)) && p(6);
  return crossings == 1 && n >= 2 && n <= 3 && !blocked;
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
