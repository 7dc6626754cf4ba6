#pragma once

#include <cmath>
#include <cstdint>

#include "core/depth_noise.hpp"
#include "core/image_view.hpp"
#include "core/neighbours.hpp"

namespace facet {

enum class DepthEdgeMode {
  jump,   ///< slope-corrected jump to a neighbour, on the nearer side
  canny,  ///< the paper: Canny on the magnitude of the depth gradient
};

struct DepthEdgeParams {
  DepthEdgeMode mode = DepthEdgeMode::jump;
  float jump_ratio = 0.015f;   ///< jump: least jump relative to depth [m/m], 0..1
  float noise_sigmas = 4.0f;   ///< jump: least jump in standard deviations of the sensor noise, 0..100
  float high_per_px = 0.010f;  ///< canny: upper threshold, relative depth change per pixel [1/px], 0..10
  float low_per_px = 0.005f;   ///< canny: lower threshold [1/px], 0..10
  bool relocate = true;        ///< canny: move edge pixels to the occluding (nearer) side
};

/// Strength for Canny: magnitude of the depth gradient relative to depth [1/px], so that one threshold fits
/// near and far; direction: the direction4 nearest to the gradient. Missing pixels have strength 0.
struct DepthGradientStrengthOp {
  static constexpr int radius = 0;
  ImageView<const float> depth_m, gx, gy;
  ImageView<float> strength;
  ImageView<std::uint8_t> direction;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    const float z = depth_m(x, y);
    const float dx = gx(x, y), dy = gy(x, y);
    strength(x, y) = z > 0 ? sqrtf(dx * dx + dy * dy) / z : 0.0f;
    direction(x, y) = static_cast<std::uint8_t>(direction4_of(dx, dy));
  }
};

/// A depth [m] and its inverse [1/m].
struct DepthReading {
  float m, inverse;
};

/// Whether a neighbour lies deeper than the planes on both sides predict. Works in inverse depth, where a
/// plane is exactly affine in pixels, so a steep plane is no jump.
struct DepthJump {
  float jump_ratio;
  float noise_sigmas;
  DepthNoise noise;

  /// `far`: the neighbour; `before`: two pixels to the other side; `beyond`: three pixels to the neighbour's.
  FACET_HD bool operator()(DepthReading here, DepthReading before, DepthReading far,
                           DepthReading beyond) const {
    const float by_noise = noise_sigmas * noise.sigma_m(here.m);
    const float by_ratio = jump_ratio * here.m;
    const float least_m = by_noise > by_ratio ? by_noise : by_ratio;
    const float step = here.inverse - far.inverse;
    const float near_slope = slope(before, here, by_ratio), far_slope = slope(far, beyond, by_ratio);
    const float slope_max = near_slope > far_slope ? near_slope : far_slope;
    return (here.m > 0) & (far.m > here.m) & ((step - slope_max) * here.m * here.m > least_m);
  }

 private:
  /// Fall of inverse depth per pixel over a baseline of two pixels, 0 where it is unknown, rises, or jumps
  /// itself.
  FACET_HD static float slope(DepthReading from, DepthReading to, float jump_m) {
    const bool known = (from.m > 0) & (to.m > from.m) & !(to.m - from.m > 2 * jump_m);
    return known ? 0.5f * (from.inverse - to.inverse) : 0.0f;
  }
};

/// Depth discontinuity without Canny: a jump to a 4-neighbour. The mark is set on the nearer pixel: the
/// occluding side owns the edge.
struct DepthJumpOp {
  static constexpr int radius = 3;
  ImageView<const float> depth_m;
  DepthJump is_jump;
  ImageView<std::uint8_t> edge;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access access) const {
    bool jump = false;
    for (int i = 0; i < 8; i += 2) {
      const Offset d = neighbour8(i);
      const auto reading = [&](int k) {
        const float z = access.clamped(depth_m, x + k * d.dx, y + k * d.dy);
        return DepthReading{z, 1 / z};
      };
      jump |= is_jump(reading(0), reading(-2), reading(1), reading(3));
    }
    edge(x, y) = jump;
  }
};

/// Where the edge at (x, y) belongs: itself, or its neighbour along the gradient if that side is the nearer
/// one.
struct OccludingSide {
  ImageView<const float> depth_m;
  ImageView<const std::uint8_t> direction;

  FACET_HD Offset operator()(int x, int y) const {
    const Offset d = direction4(direction(x, y));
    const float z = depth_m(x, y);
    const float before = at(x - d.dx, y - d.dy, z);
    const float after = at(x + d.dx, y + d.dy, z);
    const bool towards_before = before < after;
    const float nearer = towards_before ? before : after;
    const float farther = towards_before ? after : before;
    if (z - nearer <= farther - z) return {0, 0};
    return towards_before ? Offset{-d.dx, -d.dy} : d;
  }

 private:
  FACET_HD float at(int x, int y, float otherwise) const {
    return depth_m.size().contains(x, y) && depth_m(x, y) > 0 ? depth_m(x, y) : otherwise;
  }
};

/// Moves Canny's edge pixels, which may fall on either side of a jump, to the occluding side (a gather: each
/// pixel asks which of its neighbours move onto it).
struct RelocateOp {
  static constexpr int radius = 1;
  ImageView<const std::uint8_t> edge;
  OccludingSide occluding_side;
  ImageView<std::uint8_t> out;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access access) const {
    bool set = false;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        if (!access.or_zero(edge, x + dx, y + dy)) continue;
        const Offset move = occluding_side(x + dx, y + dy);
        set |= move.dx == -dx && move.dy == -dy;
      }
    out(x, y) = set;
  }
};

template <class Executor>
void depth_gradient_strength(Executor& executor, ImageView<const float> depth_m, ImageView<const float> gx,
                             ImageView<const float> gy, ImageView<float> strength,
                             ImageView<std::uint8_t> direction) {
  executor.for_each_pixel(depth_m.size(), DepthGradientStrengthOp{depth_m, gx, gy, strength, direction});
}

template <class Executor>
void depth_jumps(Executor& executor, const DepthEdgeParams& params, const DepthNoise& noise,
                 ImageView<const float> depth_m, ImageView<std::uint8_t> edge) {
  executor.for_each_pixel(depth_m.size(),
                          DepthJumpOp{depth_m, {params.jump_ratio, params.noise_sigmas, noise}, edge});
}

template <class Executor>
void relocate_to_occluding_side(Executor& executor, ImageView<const float> depth_m,
                                ImageView<const std::uint8_t> direction, ImageView<const std::uint8_t> edge,
                                ImageView<std::uint8_t> out) {
  executor.for_each_pixel(edge.size(), RelocateOp{edge, {depth_m, direction}, out});
}

}  // namespace facet
