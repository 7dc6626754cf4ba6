#pragma once

#include "core/image_view.hpp"

namespace facet {

enum class GradientOperator {
  sobel,    ///< 3x3 Sobel, scaled to metres per pixel
  central,  ///< plain central differences (figure 5's comparison)
};

struct GradientParams {
  GradientOperator op = GradientOperator::sobel;
};

/// Depth of a neighbour, or of the centre where the neighbour is missing: a hole adds no slope.
FACET_HD inline float known_or(float z, float centre) {
  return z > 0 ? z : centre;
}

/// 3x3 Sobel derivative [m/px]: kernel weights sum to 1 per pixel of distance.
struct SobelOp {
  static constexpr int radius = 1;
  ImageView<const float> depth_m;
  ImageView<float> gx, gy;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access access) const {
    const float c = depth_m(x, y);
    const float nw = known_or(access.clamped(depth_m, x - 1, y - 1), c);
    const float n = known_or(access.clamped(depth_m, x, y - 1), c);
    const float ne = known_or(access.clamped(depth_m, x + 1, y - 1), c);
    const float w = known_or(access.clamped(depth_m, x - 1, y), c);
    const float e = known_or(access.clamped(depth_m, x + 1, y), c);
    const float sw = known_or(access.clamped(depth_m, x - 1, y + 1), c);
    const float s = known_or(access.clamped(depth_m, x, y + 1), c);
    const float se = known_or(access.clamped(depth_m, x + 1, y + 1), c);
    const float known = c > 0 ? 0.125f : 0.0f;
    gx(x, y) = known * ((ne - nw) + 2 * (e - w) + (se - sw));
    gy(x, y) = known * ((sw - nw) + 2 * (s - n) + (se - ne));
  }
};

/// Central difference [m/px].
struct CentralDifferenceOp {
  static constexpr int radius = 1;
  ImageView<const float> depth_m;
  ImageView<float> gx, gy;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access access) const {
    const float c = depth_m(x, y);
    const float known = c > 0 ? 0.5f : 0.0f;
    gx(x, y) = known * (known_or(access.clamped(depth_m, x + 1, y), c) -
                        known_or(access.clamped(depth_m, x - 1, y), c));
    gy(x, y) = known * (known_or(access.clamped(depth_m, x, y + 1), c) -
                        known_or(access.clamped(depth_m, x, y - 1), c));
  }
};

/// Standard deviation of the gradient per unit of depth noise (independent pixels): root of the sum of
/// squared weights.
FACET_HD inline float gradient_noise_factor(GradientOperator op) {
  return op == GradientOperator::sobel ? 0.4330127f : 0.7071068f;
}

/// Depth gradient (paper eq. 5). Writes gx, gy [m/px]; zero where the pixel is missing.
template <class Executor>
void gradient(Executor& executor, const GradientParams& params, ImageView<const float> depth_m,
              ImageView<float> gx, ImageView<float> gy) {
  if (params.op == GradientOperator::sobel)
    executor.for_each_pixel(depth_m.size(), SobelOp{depth_m, gx, gy});
  else
    executor.for_each_pixel(depth_m.size(), CentralDifferenceOp{depth_m, gx, gy});
}

}  // namespace facet
