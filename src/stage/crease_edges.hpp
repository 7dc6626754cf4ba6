#pragma once

#include <cmath>
#include <cstdint>

#include "core/angle.hpp"
#include "core/camera.hpp"
#include "core/depth_noise.hpp"
#include "core/image_view.hpp"
#include "core/neighbours.hpp"
#include "core/normal_views.hpp"
#include "core/vec.hpp"

namespace facet {

enum class CreaseMode {
  normals,   ///< angle between the normals of plane fits on both sides of the pixel
  paper,     ///< eq. 6: gradient of the direction of the depth gradient
  gaussian,  ///< section 3.2: gradient of the Gaussian curvature
};
enum class CreaseAngle {
  atan2,  ///< full direction, differences wrapped to +-180 degrees
  atan,   ///< eq. 6 as printed: opposite gradients fold onto each other
};

enum class CreaseClosure {
  basins,  ///< watershed of the strength, then merging across weak borders: closed lines
  canny,   ///< the paper: non-maximum suppression and hysteresis; lines may have gaps
};

struct CreaseParams {
  CreaseMode mode = CreaseMode::normals;
  CreaseAngle angle = CreaseAngle::atan2;  ///< paper mode only
  bool weighted = true;  ///< paper mode: damp directions whose gradient is below its own noise
  int radius_px = 3;     ///< normals: half side of the fit window [px], 1..16
  CreaseClosure closure = CreaseClosure::basins;  ///< basins needs mode normals
  float floor_deg = 6.0f;  ///< basins: change of direction below this is noise of the fits [deg], 0..180
  float high_deg = 25.0f;  ///< upper threshold on the change of direction across the pixel [deg], 0..180
  float low_deg = 12.0f;   ///< lower threshold [deg], 0..180
  int depth_guard_px = 3;  ///< no crease within this distance of a depth edge [px], 0..16
};

/// Unit direction of the depth gradient and how far it can be trusted. A gradient below float resolution has
/// the direction (1, 0), what atan2(0, 0) = 0 means in eq. 6; missing pixels have weight 0.
struct GradientDirectionOp {
  static constexpr int radius = 0;
  ImageView<const float> depth_m, gx, gy;
  bool weighted;
  float noise_factor;  ///< deviation of the gradient per deviation of the depth
  DepthNoise noise;
  ImageView<float> ux, uy, weight;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    const float z = depth_m(x, y);
    const float dx = gx(x, y), dy = gy(x, y);
    const float magnitude = sqrtf(dx * dx + dy * dy);
    const bool defined = magnitude > 2e-6f * z;
    const float scale = defined ? 1 / (magnitude > 0 ? magnitude : 1.0f) : 0.0f;
    const float trust = magnitude / (3 * noise_factor * noise.sigma_m(z));
    const float w = weighted && trust < 1 ? trust : 1.0f;
    ux(x, y) = defined ? dx * scale : 1.0f;
    uy(x, y) = dy * scale;
    weight(x, y) = z > 0 ? w : 0.0f;
  }
};

/// Change of gradient direction across the pixel, over a baseline of two pixels along x and along y [deg]
/// (paper eq. 6, wrap-safe). `fold` treats opposite directions as equal, as atan of the ratio does.
struct DirectionChangeOp {
  static constexpr int radius = 1;
  ImageView<const float> ux, uy, weight;
  bool fold;
  ImageView<float> strength;
  ImageView<std::uint8_t> direction;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access access) const {
    const float along_x = turn_deg(x - 1, y, x + 1, y, access);
    const float along_y = turn_deg(x, y - 1, x, y + 1, access);
    const float ax = along_x < 0 ? -along_x : along_x;
    const float ay = along_y < 0 ? -along_y : along_y;
    strength(x, y) = sqrtf(ax * ax + ay * ay);
    // The sign of a turn by half a circle is arbitrary, so the two parts give a sector but no diagonal's
    // sense.
    direction(x, y) = ax >= ay ? 0 : 2;
  }

 private:
  template <class Access>
  FACET_HD float turn_deg(int x0, int y0, int x1, int y1, Access access) const {
    const float cx = access.clamped(ux, x0, y0), sx = access.clamped(uy, x0, y0);
    const float cy = access.clamped(ux, x1, y1), sy = access.clamped(uy, x1, y1);
    const float w0 = access.clamped(weight, x0, y0), w1 = access.clamped(weight, x1, y1);
    const float dot = cx * cy + sx * sy;
    const float cross = cx * sy - sx * cy;
    const float angle = arctangent2(cross, fold && dot < 0 ? -dot : dot);
    return degrees_per_radian * angle * (w0 < w1 ? w0 : w1);
  }
};

/// Gaussian curvature of the depth surface times the area of a pixel at that depth: the solid angle, in
/// rad^2, by which the normal turns within one pixel (section 3.2). Zero on every straight crease: one of the
/// two principal curvatures vanishes there.
struct GaussianCurvatureOp {
  static constexpr int radius = 1;
  ImageView<const float> depth_m, gx, gy;
  float focal_px;
  ImageView<float> curvature;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access access) const {
    const float z = depth_m(x, y);
    const float pixel_m = (z > 0 ? z : 1.0f) / focal_px;
    const float zxx = 0.5f * (access.clamped(gx, x + 1, y) - access.clamped(gx, x - 1, y)) / pixel_m;
    const float zyy = 0.5f * (access.clamped(gy, x, y + 1) - access.clamped(gy, x, y - 1)) / pixel_m;
    const float zxy = 0.5f * (access.clamped(gx, x, y + 1) - access.clamped(gx, x, y - 1)) / pixel_m;
    const float slope_x = gx(x, y) / pixel_m, slope_y = gy(x, y) / pixel_m;
    const float steepness = 1 + slope_x * slope_x + slope_y * slope_y;
    curvature(x, y) = z > 0 ? (zxx * zyy - zxy * zxy) / (steepness * steepness) : 0.0f;
  }
};

/// Magnitude of the gradient of the Gaussian curvature, as an angle: root of its change over two pixels
/// [deg].
struct CurvatureGradientOp {
  static constexpr int radius = 1;
  ImageView<const float> curvature;
  ImageView<float> strength;
  ImageView<std::uint8_t> direction;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access access) const {
    const float kx = access.clamped(curvature, x + 1, y) - access.clamped(curvature, x - 1, y);
    const float ky = access.clamped(curvature, x, y + 1) - access.clamped(curvature, x, y - 1);
    strength(x, y) = degrees_per_radian * sqrtf(sqrtf(kx * kx + ky * ky));
    direction(x, y) = static_cast<std::uint8_t>(direction4_of(kx, ky));
  }
};

/// Angle between the normals on both sides of the pixel, `radius` away from it, the largest of four
/// directions, as the chord |n1 - n2| = 2 sin(angle / 2): no arc cosine before a decision. Pixels near a
/// depth edge or a hole (distance below `guard_px`) have strength 0.
struct NormalChangeOp {
  NormalViews<const float> normal;
  ImageView<const std::uint8_t> distance_px;
  int radius;
  int guard_px;
  ImageView<float> strength;
  ImageView<std::uint8_t> direction;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access access) const {
    float best = 0;
    int across = 0;
    FACET_UNROLL for (int i = 0; i < 4; ++i) {
      const float c = chord_squared(x, y, direction4(i), access);
      const bool larger = c > best;
      best = larger ? c : best;
      across = larger ? i : across;
    }
    const bool guarded = distance_px(x, y) <= guard_px;
    strength(x, y) = sqrtf(guarded ? 0.0f : best);
    direction(x, y) = static_cast<std::uint8_t>(guarded ? 0 : across);
  }

 private:
  /// Squared chord over +-radius, or 0 where either side has no normal.
  template <class Access>
  FACET_HD float chord_squared(int x, int y, Offset d, Access access) const {
    const int step = d.dx != 0 && d.dy != 0 ? (radius * 3 + 2) / 4 : radius;  // diagonals are longer
    const Vec3 a = normal_at(x - step * d.dx, y - step * d.dy, access);
    const Vec3 b = normal_at(x + step * d.dx, y + step * d.dy, access);
    const bool known = (dot(a, a) > 0) & (dot(b, b) > 0);
    return known ? dot(a - b, a - b) : 0.0f;
  }
  template <class Access>
  FACET_HD Vec3 normal_at(int x, int y, Access access) const {
    return {access.or_zero(normal.x, x, y), access.or_zero(normal.y, x, y), access.or_zero(normal.z, x, y)};
  }
};

/// Scratch images of the crease strengths, all of the frame's size.
struct CreaseScratch {
  ImageView<float> a, b, c;
};

/// Crease strength from the direction of the depth gradient (paper eq. 6) [deg over two pixels].
template <class Executor>
void direction_change(Executor& executor, const CreaseParams& params, float gradient_noise,
                      const DepthNoise& noise, ImageView<const float> depth_m, ImageView<const float> gx,
                      ImageView<const float> gy, const CreaseScratch& scratch, ImageView<float> strength,
                      ImageView<std::uint8_t> direction) {
  const Size size = depth_m.size();
  executor.for_each_pixel(size, GradientDirectionOp{depth_m, gx, gy, params.weighted, gradient_noise, noise,
                                                    scratch.a, scratch.b, scratch.c});
  executor.for_each_pixel(size, DirectionChangeOp{scratch.a, scratch.b, scratch.c,
                                                  params.angle == CreaseAngle::atan, strength, direction});
}

/// Crease strength from the Gaussian curvature (paper section 3.2) [deg over two pixels].
template <class Executor>
void curvature_gradient(Executor& executor, const Camera& camera, ImageView<const float> depth_m,
                        ImageView<const float> gx, ImageView<const float> gy, const CreaseScratch& scratch,
                        ImageView<float> strength, ImageView<std::uint8_t> direction) {
  executor.for_each_pixel(depth_m.size(), GaussianCurvatureOp{depth_m, gx, gy, camera.fx, scratch.a});
  executor.for_each_pixel(depth_m.size(), CurvatureGradientOp{scratch.a, strength, direction});
}

/// Crease strength from fitted normals [chord length, 2 sin(angle / 2)].
template <class Executor>
void normal_change(Executor& executor, const CreaseParams& params, const NormalViews<const float>& normal,
                   ImageView<const std::uint8_t> distance_px, ImageView<float> strength,
                   ImageView<std::uint8_t> direction) {
  executor.for_each_pixel(normal.size(), NormalChangeOp{normal, distance_px, params.radius_px,
                                                        params.depth_guard_px, strength, direction});
}

}  // namespace facet
