#pragma once

#include <cstdint>

#include "core/image_view.hpp"
#include "core/neighbour_table.hpp"
#include "stage/mask_by_table.hpp"

namespace facet {

enum class PruningMode {
  stability,  ///< remove every open branch: what is left bounds a region
  gonzalez,   ///< eq. 10: n thinnings by end points, then n conditional dilations from the new ends
  none,
};

struct PruningParams {
  PruningMode mode = PruningMode::stability;
  int iterations = 10;  ///< gonzalez: n, the longest spur that vanishes [px], 0..100
};

/// End points of a thin line: no neighbour, one neighbour, or two that touch each other on a side.
constexpr bool is_end_point(unsigned code) {
  int count = 0;
  bool adjacent = false;
  for (unsigned i = 0; i < 8; ++i) {
    if (!(code >> i & 1u)) continue;
    ++count;
    adjacent |= (code >> ((i + 1) % 8) & 1u) != 0;
  }
  return count <= 1 || (count == 2 && adjacent);
}
inline constexpr NeighbourTable end_point_table = make_neighbour_table(is_end_point);

/// Whether a line whose end point is (x, y), with these neighbours, meets the image border there instead of running
/// along it. It has no open end then: it bounds the regions on both of its sides.
FACET_HD inline bool meets_image_border(Size size, int x, int y, unsigned code) {
  unsigned outside = 0;
  for (int i = 0; i < 8; ++i)
    if (!size.contains(x + neighbour8(i).dx, y + neighbour8(i).dy)) outside |= 1u << i;
  const unsigned beside_outside = outside << 1 | outside >> 7 | outside >> 1 | outside << 7;
  return outside != 0 && code != 0 && (code & beside_outside) == 0;
}

/// Marks the end points of a line, but for those where it meets the image border.
struct MarkEndPointOp {
  static constexpr int radius = 0;
  NeighbourTable end_points;
  ImageView<const std::uint8_t> edge;
  ImageView<std::uint8_t> mark;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    const unsigned code = neighbour_code(edge, x, y);
    mark(x, y) = end_points[code] && !meets_image_border(edge.size(), x, y, code);
  }
};

/// One step of the conditional dilation: original edge pixels beside the front join it. Reads `front`, writes `grown`.
struct ConditionalDilationOp {
  static constexpr int radius = 0;
  ImageView<const std::uint8_t> front;
  ImageView<std::uint8_t> grown;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    const GuardedAccess access;
    bool reached = false;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) reached |= access.or_zero(front, x + dx, y + dy) != 0;
    grown(x, y) = reached;
  }
};

/// Adds one mask to another.
struct JoinOp {
  static constexpr int radius = 0;
  ImageView<const std::uint8_t> from;
  ImageView<std::uint8_t> into;
  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    into(x, y) |= from(x, y);
  }
};

/// Removes end points `passes` times, all of one pass at once. `mark` must be zero and is left so.
template <class Executor>
void remove_end_points(Executor& executor, int passes, ImageView<std::uint8_t> edge, ImageView<std::uint8_t> mark) {
  executor.take_changed();
  for (int pass = 0; pass < passes; ++pass) {
    executor.for_each_set(edge, MarkEndPointOp{end_point_table, edge, mark});
    executor.for_each_set(edge, DeleteMarkedOp{edge, mark, executor.changed_flag()});
    if (!executor.take_changed()) break;
  }
}

/// Scratch masks of the pruning, all of the frame's size.
struct PruningScratch {
  ImageView<std::uint8_t> original, mark, grown;
};

/// Pruning of a thin edge mask in place (paper eq. 10; Gonzalez and Woods). `stability` removes every open branch:
/// only closed loops, and lines between them or the image border, remain. `gonzalez` removes end points n times (X1),
/// finds the end points of what is left (X2), grows them back along the original n times (X3) and returns the union
/// (X4): spurs of up to n pixels vanish, longer lines keep their length.
template <class Executor>
void prune(Executor& executor, const PruningParams& params, ImageView<std::uint8_t> edge,
           const PruningScratch& scratch) {
  if (params.mode == PruningMode::none) return;
  executor.fill(scratch.mark, std::uint8_t{0});
  if (params.mode == PruningMode::stability) {
    remove_end_points(executor, edge.width * edge.height, edge, scratch.mark);
    return;
  }
  executor.copy(ImageView<const std::uint8_t>(edge), scratch.original);
  remove_end_points(executor, params.iterations, edge, scratch.mark);
  executor.for_each_set(edge, MarkEndPointOp{end_point_table, edge, scratch.mark});
  executor.fill(scratch.grown, std::uint8_t{0});
  for (int i = 0; i < params.iterations; ++i) {
    executor.for_each_set(scratch.original, ConditionalDilationOp{scratch.mark, scratch.grown});
    executor.copy(ImageView<const std::uint8_t>(scratch.grown), scratch.mark);
  }
  executor.for_each_pixel(edge.size(), JoinOp{scratch.mark, edge});
}

}  // namespace facet
