#pragma once

#include "core/rigid_motion.hpp"

namespace facet {

/// A segment or an arc of a circle in space, where patches of an object end or meet.
struct Curve {
  bool is_arc = false;
  Vec3d start{}, end{};  ///< of a segment [m]
  RigidMotion frame{};   ///< of an arc: the circle lies in z = 0 about the origin
  double radius_m = 0;
  double from_rad = 0, to_rad = 2 * M_PI;
  int patch_a = 0;   ///< index of a patch that ends here
  int patch_b = -1;  ///< the other one; -1: the edge of a thin wall, or a silhouette

  bool closed() const { return is_arc && to_rad - from_rad > 2 * M_PI - 1e-9; }
  /// Point at 0 <= u <= 1.
  Vec3d at(double u) const {
    if (!is_arc) return start + u * (end - start);
    const double angle = from_rad + u * (to_rad - from_rad);
    return frame.apply({radius_m * std::cos(angle), radius_m * std::sin(angle), 0});
  }
  Curve moved(const RigidMotion& motion) const {
    Curve out = *this;
    out.start = motion.apply(start);
    out.end = motion.apply(end);
    out.frame = motion * frame;
    return out;
  }
};

}  // namespace facet
