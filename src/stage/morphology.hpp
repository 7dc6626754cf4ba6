#pragma once

#include <cstdint>
#include <utility>

#include "core/image_view.hpp"

namespace facet {

enum class MorphologyMode {
  none,    ///< leave the edges as they are
  bridge,  ///< dilate, so that gaps close
  paper,   ///< eqs 7-9: difference of two openings of the dilated contours
};

struct MorphologyParams {
  MorphologyMode mode = MorphologyMode::none;
  int bridge_px = 1;          ///< bridge: dilation that closes gaps before thinning [px], 0..5
  int small_element_px = 3;   ///< paper: side of B2, odd [px], 3..31
  int large_element_px = 11;  ///< paper: side of B1, odd [px], 3..63
};

/// Dilation or erosion of a 0/1 mask by the 3x3 square. The image continues beyond its edge as on it.
template <bool dilate>
struct Square3Op {
  static constexpr int radius = 1;
  ImageView<const std::uint8_t> in;
  ImageView<std::uint8_t> out;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access access) const {
    std::uint8_t value = in(x, y);
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const std::uint8_t v = access.clamped(in, x + dx, y + dy);
        value = dilate ? (value | v) : (value & v);
      }
    out(x, y) = value;
  }
};

struct UnionOp {
  static constexpr int radius = 0;
  ImageView<const std::uint8_t> a, b;
  ImageView<std::uint8_t> out;
  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    out(x, y) = a(x, y) | b(x, y);
  }
};

struct DifferenceOp {
  static constexpr int radius = 0;
  ImageView<const std::uint8_t> a, b;
  ImageView<std::uint8_t> out;
  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    out(x, y) = a(x, y) & static_cast<std::uint8_t>(!b(x, y));
  }
};

template <class Executor>
void unite(Executor& executor, ImageView<const std::uint8_t> a, ImageView<const std::uint8_t> b,
           ImageView<std::uint8_t> out) {
  executor.for_each_pixel(out.size(), UnionOp{a, b, out});
}

/// Dilation (or erosion) by the (2 steps + 1)^2 square, in place; `scratch` is overwritten.
template <bool dilate, class Executor>
void square_steps(Executor& executor, int steps, ImageView<std::uint8_t>& mask,
                  ImageView<std::uint8_t>& scratch) {
  for (int i = 0; i < steps; ++i) {
    executor.for_each_pixel(mask.size(), Square3Op<dilate>{mask, scratch});
    std::swap(mask, scratch);
  }
}

/// Opening by the square of odd side `side_px`: what cannot hold the square vanishes.
template <class Executor>
void open_square(Executor& executor, int side_px, ImageView<std::uint8_t>& mask,
                 ImageView<std::uint8_t>& scratch) {
  square_steps<false>(executor, side_px / 2, mask, scratch);
  square_steps<true>(executor, side_px / 2, mask, scratch);
}

/// Smooths the edge mask `edge` in place; it is to be thinned afterwards. `bridge` mode dilates, so that gaps
/// of up to 2 bridge_px close. `paper` mode is the band-pass of eqs 7-9 on the dilated contours, opening by
/// B2 less opening by B1: it keeps what is at least B2 and less than B1 thick (undilated lines would vanish
/// in both).
template <class Executor>
void morphology(Executor& executor, const MorphologyParams& params, ImageView<std::uint8_t> edge,
                ImageView<std::uint8_t> scratch_a, ImageView<std::uint8_t> scratch_b) {
  if (params.mode == MorphologyMode::none) return;
  ImageView<std::uint8_t> fine = scratch_a, spare = scratch_b;
  executor.copy(ImageView<const std::uint8_t>(edge), fine);
  if (params.mode == MorphologyMode::bridge) {
    square_steps<true>(executor, params.bridge_px, fine, spare);
    executor.copy(ImageView<const std::uint8_t>(fine), edge);
    return;
  }
  square_steps<true>(executor, 1, fine, spare);
  open_square(executor, params.small_element_px, fine, spare);
  ImageView<std::uint8_t> coarse = edge;
  executor.copy(ImageView<const std::uint8_t>(fine), coarse);
  open_square(executor, params.large_element_px, coarse, spare);
  executor.for_each_pixel(edge.size(), DifferenceOp{fine, coarse, spare});
  if (spare.data != edge.data) executor.copy(ImageView<const std::uint8_t>(spare), edge);
}

}  // namespace facet
