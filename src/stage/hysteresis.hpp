#pragma once

#include <cstdint>

#include "core/atomic.hpp"
#include "core/image_view.hpp"
#include "core/neighbours.hpp"
#include "stage/ridge.hpp"

namespace facet {

struct StrongRidgeOp {
  static constexpr int radius = 0;
  ImageView<const std::uint8_t> ridge;
  ImageView<std::uint8_t> edge;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    edge(x, y) = ridge(x, y) == static_cast<std::uint8_t>(Ridge::strong);
  }
};

/// One pass: a weak pixel beside an edge becomes an edge. Passes may see each other's results in any order,
/// as the set only grows towards the one fixed point.
struct GrowEdgeOp {
  static constexpr int radius = 0;
  ImageView<std::uint8_t> ridge;
  ImageView<std::uint8_t> edge;
  int* changed;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    if (edge(x, y)) return;
    for (int i = 0; i < 8; ++i) {
      const int nx = x + neighbour8(i).dx, ny = y + neighbour8(i).dy;
      if (edge.size().contains(nx, ny) && edge(nx, ny)) {
        edge(x, y) = 1;
        raise_flag(changed);
        return;
      }
    }
  }
};

/// Canny's last step: edges are the strong ridges and the weak ones 8-connected to them. Writes 0 or 1.
template <class Executor>
void hysteresis(Executor& executor, ImageView<std::uint8_t> ridge, ImageView<std::uint8_t> edge) {
  executor.for_each_pixel(ridge.size(), StrongRidgeOp{ridge, edge});
  executor.take_changed();
  do {
    executor.for_each_set(ridge, GrowEdgeOp{ridge, edge, executor.changed_flag()});
  } while (executor.take_changed());
}

}  // namespace facet
