#include "surface/patch_seam.hpp"

#include <algorithm>
#include <cmath>

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

SeamDifference seam_difference(const PatchFit& a, const PatchFit& b, std::span<const SeamPoint> seam,
                               double focal_px, const SeamTolerance& tolerance) {
  double angle = 0, step = 0;
  for (const auto& [x, y] : seam) {
    const PatchPoint pa = a.at(x, y), pb = b.at(x, y);
    angle += squared_chord(pa, pb, x, y, focal_px);
    step += square(pa.q - pb.q) / std::abs(pa.q * pb.q);
  }
  angle /= static_cast<double>(seam.size()), step /= static_cast<double>(seam.size());
  const auto [x, y] = seam[seam.size() / 2];
  const SeamVariance va = variance_of(a, x, y, focal_px), vb = variance_of(b, x, y, focal_px);
  const double angle_noise = va.angle + vb.angle, step_noise = va.step + vb.step;
  const double most_angle = square(tolerance.angle_rad), most_step = square(tolerance.step_ratio);
  const double s = square(tolerance.sigmas);
  return {std::sqrt(std::max(angle / (most_angle + s * angle_noise), step / (most_step + s * step_noise))),
          std::sqrt(std::max((angle + angle_noise) / most_angle, (step + step_noise) / most_step))};
}

}  // namespace facet
