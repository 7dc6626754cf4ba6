#pragma once

#include <cstdint>

#include "core/image_view.hpp"
#include "core/neighbour_rule.hpp"
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
template <class Word>
FACET_HD constexpr Word is_end_point(const Neighbours<Word>& neighbours) {
  const auto& p = neighbours.p;
  Word one = p[0], two = 0, three = 0, adjacent = p[7] & p[0];  // at least one set, two, three
  for (int i = 1; i < 8; ++i) {
    three |= two & p[i];
    two |= one & p[i];
    one |= p[i];
    adjacent |= p[i - 1] & p[i];
  }
  return ~two | (~three & adjacent);
}

/// Whether a line has an open end at a pixel: an end point that may go without joining two regions or making
/// one. `walls`: its neighbours that bound regions, the line's own among them.
template <class Word>
FACET_HD constexpr Word is_open_end(const Neighbours<Word>& line, const Neighbours<Word>& walls) {
  const auto& p = walls.p;
  const Word no_wall = ~(p[0] | p[1] | p[2] | p[3] | p[4] | p[5] | p[6] | p[7]);
  return is_end_point(line) & (one_crossing(p) | no_wall);
}

/// Open ends of the lines of a mask. The image border and missing depth bound regions as an edge does, so a
/// line that meets them has no open end there, while one that runs along them has.
struct OpenEnd {
  ImageView<const float> depth_m;

  FACET_HD bool operator()(int x, int y, unsigned code) const {
    const unsigned walls = code | barriers(x, y);
    return (is_open_end(neighbours_of(code), neighbours_of(walls)) & 1u) != 0;
  }

 private:
  FACET_HD unsigned barriers(int x, int y) const {
    unsigned code = 0;
    for (int i = 0; i < 8; ++i) {
      const int nx = x + neighbour8(i).dx, ny = y + neighbour8(i).dy;
      if (!depth_m.size().contains(nx, ny) || !(depth_m(nx, ny) > 0)) code |= 1u << i;
    }
    return code;
  }
};

/// Marks the open ends of the edge mask.
struct MarkOpenEndOp {
  static constexpr int radius = 0;
  OpenEnd open_end;
  ImageView<const std::uint8_t> edge;
  ImageView<std::uint8_t> mark;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    mark(x, y) = open_end(x, y, neighbour_code(edge, x, y));
  }
};

/// One step of the conditional dilation: original edge pixels beside the front join it. Reads `front`, writes
/// `grown`.
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
void remove_open_ends(Executor& executor, int passes, const OpenEnd& open_end, ImageView<std::uint8_t> edge,
                      ImageView<std::uint8_t> mark) {
  executor.take_changed();
  for (int pass = 0; pass < passes; ++pass) {
    executor.for_each_set(edge, MarkOpenEndOp{open_end, edge, mark});
    executor.for_each_set(edge, DeleteMarkedOp{edge, mark, executor.changed_flag()});
    if (!executor.take_changed()) break;
  }
}

/// Scratch masks of the pruning, all of the frame's size.
struct PruningScratch {
  ImageView<std::uint8_t> original, mark, grown;
};

/// Pruning of a thin edge mask in place (paper eq. 10; Gonzalez and Woods). `stability` removes every open
/// branch: only closed loops, and lines between them, missing depth or the image border, remain. `gonzalez`
/// removes end points n times (X1), finds the end points of what is left (X2), grows them back along the
/// original n times (X3) and returns the union (X4): spurs of up to n pixels vanish, longer lines keep their
/// length.
template <class Executor>
void prune(Executor& executor, const PruningParams& params, ImageView<const float> depth_m,
           ImageView<std::uint8_t> edge, const PruningScratch& scratch) {
  if (params.mode == PruningMode::none) return;
  const OpenEnd open_end{depth_m};
  executor.fill(scratch.mark, std::uint8_t{0});
  if (params.mode == PruningMode::stability) {
    remove_open_ends(executor, edge.width * edge.height, open_end, edge, scratch.mark);
    return;
  }
  executor.copy(ImageView<const std::uint8_t>(edge), scratch.original);
  remove_open_ends(executor, params.iterations, open_end, edge, scratch.mark);
  executor.for_each_set(edge, MarkOpenEndOp{open_end, edge, scratch.mark});
  executor.fill(scratch.grown, std::uint8_t{0});
  for (int i = 0; i < params.iterations; ++i) {
    executor.for_each_set(scratch.original, ConditionalDilationOp{scratch.mark, scratch.grown});
    executor.copy(ImageView<const std::uint8_t>(scratch.grown), scratch.mark);
  }
  executor.for_each_pixel(edge.size(), JoinOp{scratch.mark, edge});
}

}  // namespace facet
