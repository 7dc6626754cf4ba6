#pragma once

#include <cmath>
#include <cstdint>

#include "core/camera.hpp"
#include "core/edge_code.hpp"
#include "core/image_view.hpp"
#include "core/neighbours.hpp"

namespace facet {

enum class Convexity {
  signed_test,  ///< (p2 - p1) . (n2 - n1) > 0 across the crease
  hessian,      ///< Table 1 with z as printed: sign of the dominant eigenvalue of the depth's Hessian
};

struct EdgeKindParams {
  Convexity convexity = Convexity::signed_test;
  float hessian_dead_band_per_m = 1.0f;  ///< hessian: curvature below this is undecided [1/m], 0..1000
};

/// Signed test of a crease: over planes inverse depth is affine in pixels, so its second difference across
/// the crease tells the sign. Negative = the surface bulges towards the camera = convex; this is the sign of
/// (p2 - p1) . (n2 - n1) for normals towards the camera. Summed over distances 1 ... reach, in the direction
/// where it is largest; samples stop at missing pixels and at depth edges.
struct SecondDifference {
  static constexpr int reach = 6;
  ImageView<const float> depth_m;
  ImageView<const std::uint8_t> depth_edge;

  template <class Access>
  FACET_HD float operator()(int x, int y, Access access) const {
    float dominant = 0;
    for (int i = 0; i < 4; ++i) {
      const float s = along(x, y, direction4(i), access);
      if (s * s > dominant * dominant) dominant = s;
    }
    return dominant;
  }

 private:
  template <class Access>
  FACET_HD float along(int x, int y, Offset d, Access access) const {
    float sum = 0;
    for (int k = 1; k <= reach; ++k) {
      const int x0 = x - k * d.dx, y0 = y - k * d.dy, x1 = x + k * d.dx, y1 = y + k * d.dy;
      const float z0 = usable_depth(x0, y0, access), z1 = usable_depth(x1, y1, access);
      if (z0 == 0 || z1 == 0) break;
      sum += 1 / z0 - 2 / depth_m(x, y) + 1 / z1;
    }
    return sum;
  }
  template <class Access>
  FACET_HD float usable_depth(int x, int y, Access access) const {
    return access.or_zero(depth_edge, x, y) ? 0.0f : access.or_zero(depth_m, x, y);
  }
};

/// Table 1 of the paper as printed, with z = depth: the sign of the dominant eigenvalue of the Hessian,
/// positive = concave. For depth, which grows away from the camera, that sign is reversed (a ball has a
/// positive definite Hessian); kept for comparison. Returns the eigenvalue [1/m].
struct DominantHessianEigenvalue {
  ImageView<const float> depth_m, gx, gy;
  float focal_px;

  template <class Access>
  FACET_HD float operator()(int x, int y, Access access) const {
    const float pixel_m = depth_m(x, y) / focal_px;
    const float scale = 0.5f / (pixel_m * pixel_m);
    const float xx = scale * (access.clamped(gx, x + 1, y) - access.clamped(gx, x - 1, y));
    const float yy = scale * (access.clamped(gy, x, y + 1) - access.clamped(gy, x, y - 1));
    const float xy = scale * (access.clamped(gx, x, y + 1) - access.clamped(gx, x, y - 1));
    const float half_trace = 0.5f * (xx + yy);
    const float root = sqrtf(0.25f * (xx - yy) * (xx - yy) + xy * xy);
    return half_trace >= 0 ? half_trace + root : half_trace - root;
  }
};

/// Gives every edge pixel its code. A pixel on or beside a depth edge is a depth edge; of the others,
/// creases, the convexity decides, and what it leaves undecided counts as concave, for which no grasp is
/// claimed. Graspable are depth edges (they stand on the occluding side) and convex creases.
struct EdgeKindOp {
  static constexpr int radius = SecondDifference::reach;
  ImageView<const std::uint8_t> depth_edge;
  Convexity convexity;
  SecondDifference second_difference;
  DominantHessianEigenvalue hessian;
  float dead_band_per_m;
  ImageView<std::uint8_t> code;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access access) const {
    const EdgeKind kind = beside_depth_edge(x, y, access) ? EdgeKind::depth
                          : is_convex(x, y, access)       ? EdgeKind::convex
                                                          : EdgeKind::concave;
    code(x, y) = edge_code(kind, kind != EdgeKind::concave);
  }

 private:
  template <class Access>
  FACET_HD bool beside_depth_edge(int x, int y, Access access) const {
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        if (access.or_zero(depth_edge, x + dx, y + dy)) return true;
    return false;
  }
  template <class Access>
  FACET_HD bool is_convex(int x, int y, Access access) const {
    if (!(second_difference.depth_m(x, y) > 0)) return false;
    return convexity == Convexity::signed_test ? second_difference(x, y, access) < 0
                                               : hessian(x, y, access) < -dead_band_per_m;
  }
};

/// Codes for the pixels set in `edge` (others are left 0). gx, gy: depth gradient [m/px], used by the Hessian
/// only.
template <class Executor>
void edge_kind(Executor& executor, const EdgeKindParams& params, const Camera& camera,
               ImageView<const float> depth_m, ImageView<const float> gx, ImageView<const float> gy,
               ImageView<const std::uint8_t> depth_edge, ImageView<std::uint8_t> edge,
               ImageView<std::uint8_t> code) {
  executor.fill(code, std::uint8_t{0});
  executor.for_each_set(edge, EdgeKindOp{depth_edge,
                                         params.convexity,
                                         {depth_m, depth_edge},
                                         {depth_m, gx, gy, camera.fx},
                                         params.hessian_dead_band_per_m,
                                         code});
}

}  // namespace facet
