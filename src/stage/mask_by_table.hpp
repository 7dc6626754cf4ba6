#pragma once

#include <cstdint>

#include "core/atomic.hpp"
#include "core/neighbour_table.hpp"

namespace facet {

/// Marks the pixels whose eight neighbours are in one of the table's states.
struct MarkByTableOp {
  static constexpr int radius = 0;
  NeighbourTable table;
  ImageView<const std::uint8_t> mask;
  ImageView<std::uint8_t> mark;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    mark(x, y) = table[neighbour_code(mask, x, y)];
  }
};

/// Deletes what was marked; all pixels of a pass go at once, so their order does not matter.
struct DeleteMarkedOp {
  static constexpr int radius = 0;
  ImageView<std::uint8_t> mask, mark;
  int* changed;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    if (!mark(x, y)) return;
    mark(x, y) = 0;
    mask(x, y) = 0;
    raise_flag(changed);
  }
};

}  // namespace facet
