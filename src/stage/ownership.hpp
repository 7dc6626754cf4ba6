#pragma once

#include <cstdint>

#include "core/atomic.hpp"
#include "core/depth_noise.hpp"
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
    open(x, y) = depth_m(x, y) > 0 && label(x, y) == 0;
  }
};

/// Which region an unowned pixel belongs to: that of the neighbour nearest in depth, if the step to it is no
/// larger than a depth edge. At a depth edge, which stands on the occluding side, that is the nearer surface.
/// Ties go to the nearer neighbour, then to the lower label.
struct ChooseOwnerOp {
  static constexpr int radius = 0;
  ImageView<const float> depth_m;
  ImageView<const std::uint16_t> label;
  float jump_ratio;
  float noise_sigmas;
  DepthNoise noise;
  ImageView<std::uint16_t> choice;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    const float z = depth_m(x, y);
    const float by_noise = noise_sigmas * noise.sigma_m(z), by_ratio = jump_ratio * z;
    float best_step = by_noise > by_ratio ? by_noise : by_ratio;
    float best_depth = 1e30f;
    std::uint16_t best = 0;
    for (int i = 0; i < 8; ++i) {
      const int nx = x + neighbour8(i).dx, ny = y + neighbour8(i).dy;
      if (!label.size().contains(nx, ny) || label(nx, ny) == 0) continue;
      const float zn = depth_m(nx, ny);
      const float step = zn > z ? zn - z : z - zn;
      const bool better =
          step < best_step ||
          (step == best_step && (zn < best_depth || (zn == best_depth && label(nx, ny) < best)));
      if (better) best_step = step, best_depth = zn, best = label(nx, ny);
    }
    choice(x, y) = best;
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
