#pragma once

#include "core/image_view.hpp"

namespace facet {

/// Launch geometry of the per-pixel kernel, shared by the CUDA back end and its emulation in the tests.
struct Launch {
  static constexpr int block_width = 32;
  static constexpr int block_height = 8;
  static FACET_HD int blocks_x(Size size) { return (size.width + block_width - 1) / block_width; }
  static FACET_HD int blocks_y(Size size) { return (size.height + block_height - 1) / block_height; }
};

/// What one thread of a per-pixel launch does: the guard, then the operation under the guarded border rule.
template <class Op>
FACET_HD void run_pixel_thread(const Op& op, Size size, int x, int y) {
  if (size.contains(x, y)) op(x, y, GuardedAccess{});
}

}  // namespace facet
