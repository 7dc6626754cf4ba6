#pragma once

#include <cmath>
#include <cstdint>

#include "core/atomic.hpp"
#include "core/depth_noise.hpp"
#include "core/float_bits.hpp"
#include "core/image_view.hpp"
#include "core/neighbours.hpp"

namespace facet {

/// Pixels that belong to no region though they have depth: edges, and regions that were dropped.
struct UnownedOp {
  static constexpr int radius = 0;
  ImageView<const float> depth_m;
  ImageView<const std::uint16_t> label;
  ImageView<std::uint8_t> open;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    open(x, y) = (depth_m(x, y) > 0) & (label(x, y) == 0);
  }
};

/// Which region an unowned pixel belongs to: that of the neighbour nearest in depth, if the step to it is no
/// larger than a depth edge. At a depth edge, which stands on the occluding side, that is the nearer surface.
/// Ties go to the nearer neighbour, then to the first clockwise from the north.
struct ChooseOwnerOp {
  static constexpr int radius = 1;
  ImageView<const float> depth_m;
  ImageView<const std::uint16_t> label;
  float jump_ratio;
  float noise_sigmas;
  DepthNoise noise;
  ImageView<std::uint16_t> choice;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access access) const {
    const float z = depth_m(x, y);
    const float by_noise = noise_sigmas * noise.sigma_m(z), by_ratio = jump_ratio * z;
    std::uint64_t best_rank = rank(by_noise > by_ratio ? by_noise : by_ratio, 1e30f);
    int best = 0;
    FACET_UNROLL for (int i = 0; i < 8; ++i) {
      const int nx = x + neighbour8(i).dx, ny = y + neighbour8(i).dy;
      const int owner = access.or_zero(label, nx, ny);
      const float zn = access.or_zero(depth_m, nx, ny);
      const std::uint64_t nobody = owner == 0;  // ranks last
      const std::uint64_t r = rank(fabsf(zn - z), zn) | (std::uint64_t{0} - nobody);
      best = r < best_rank ? owner : best;
      best_rank = r < best_rank ? r : best_rank;
    }
    choice(x, y) = static_cast<std::uint16_t>(best);
  }

 private:
  /// Orders by step, then by depth, without branches: the bits of floats that are not negative are ordered as
  /// they are.
  FACET_HD static std::uint64_t rank(float step_m, float depth_m) {
    return std::uint64_t{float_bits(step_m)} << 32 | float_bits(depth_m);
  }
};

struct TakeOwnerOp {
  static constexpr int radius = 0;
  ImageView<const std::uint16_t> choice;
  ImageView<std::uint16_t> label;
  ImageView<std::uint8_t> open;
  int* changed;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    if (choice(x, y) == 0) return;
    label(x, y) = choice(x, y);
    open(x, y) = 0;
    raise_flag(changed);
  }
};

/// Gives edge pixels, and those of dropped regions, back to the surface they belong to, ring by ring, so that
/// touching surfaces have no gap between them. `open` and `choice` are scratch.
template <class Executor>
void give_back_pixels(Executor& executor, float jump_ratio, float noise_sigmas, const DepthNoise& noise,
                      ImageView<const float> depth_m, ImageView<std::uint16_t> label,
                      ImageView<std::uint8_t> open, ImageView<std::uint16_t> choice) {
  executor.for_each_pixel(label.size(), UnownedOp{depth_m, label, open});
  executor.take_changed();
  do {
    executor.for_each_set(open, ChooseOwnerOp{depth_m, label, jump_ratio, noise_sigmas, noise, choice});
    executor.for_each_set(open, TakeOwnerOp{choice, label, open, executor.changed_flag()});
  } while (executor.take_changed());
}

}  // namespace facet
