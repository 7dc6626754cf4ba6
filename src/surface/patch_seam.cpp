#include "surface/patch_seam.hpp"

#include <algorithm>
#include <cmath>

#include "core/clones.hpp"

namespace facet {
namespace {

constexpr double square(double v) {
  return v * v;
}

/// Squared chord between the normals, which are along (f qx, f qy, q - x qx - y qy): a plane in space is
/// affine in inverse depth.
double squared_chord(const PatchPoint& a, const PatchPoint& b, double x, double y, double focal_px) {
  const double ax = focal_px * a.qx, ay = focal_px * a.qy, az = a.q - x * a.qx - y * a.qy;
  const double bx = focal_px * b.qx, by = focal_px * b.qy, bz = b.q - x * b.qx - y * b.qy;
  const double lengths = (ax * ax + ay * ay + az * az) * (bx * bx + by * by + bz * bz);
  return std::max(2 - 2 * (ax * bx + ay * by + az * bz) / std::sqrt(lengths), 0.0);
}

/// Means along a seam of the squared angle, as a chord, and of the squared step relative to depth.
struct MeanSquares {
  double angle = 0, step = 0;
};
/// All points there is room for are computed, as vectors; those that are there are added up.
FACET_CPU_CLONES MeanSquares mean_squares(const PatchFit& a, const PatchFit& b, const Seam& seam,
                                          double focal_px) {
  double angle[Seam::most_points], step[Seam::most_points];
  for (std::size_t i = 0; i < Seam::most_points; ++i) {
    const double x = seam.x[i], y = seam.y[i];
    const PatchPoint pa = a.at(x, y), pb = b.at(x, y);
    angle[i] = squared_chord(pa, pb, x, y, focal_px);
    step[i] = square(pa.q - pb.q) / std::abs(pa.q * pb.q);
  }
  MeanSquares sum;
  for (int i = 0; i < seam.count; ++i) sum.angle += angle[i], sum.step += step[i];
  return {sum.angle / seam.count, sum.step / seam.count};
}

/// Variances of the angle and of the relative step that one fit contributes. A slope dz/dx = tan(t) known to
/// within s tells t to within s cos^2(t).
struct SeamVariance {
  double angle = 0, step = 0;
};
SeamVariance variance_of(const PatchFit& fit, double x, double y, double focal_px) {
  const PatchPoint p = fit.at(x, y);
  const auto [value, slope] = fit.variance_at(x, y);
  const double scale = square(focal_px / p.q);
  const double steepness = 1 + scale * (square(p.qx) + square(p.qy));
  return {scale * slope / 2 / square(steepness), value / square(p.q)};
}

}  // namespace

SeamDifference seam_difference(const PatchFit& a, const PatchFit& b, const Seam& seam, double focal_px,
                               const SeamTolerance& tolerance) {
  const auto [angle, step] = mean_squares(a, b, seam, focal_px);
  const auto middle = static_cast<std::size_t>(seam.count / 2);
  const double x = seam.x[middle], y = seam.y[middle];
  const SeamVariance va = variance_of(a, x, y, focal_px), vb = variance_of(b, x, y, focal_px);
  const double angle_noise = va.angle + vb.angle, step_noise = va.step + vb.step;
  const double most_angle = square(tolerance.angle_rad), most_step = square(tolerance.step_ratio);
  const double s = square(tolerance.sigmas);
  return {std::sqrt(std::max(angle / (most_angle + s * angle_noise), step / (most_step + s * step_noise))),
          std::sqrt(std::max((angle + angle_noise) / most_angle, (step + step_noise) / most_step))};
}

}  // namespace facet
