#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/edge_code.hpp"
#include "core/image_point.hpp"
#include "core/vec.hpp"

namespace facet {

/// A pixel of a contour: x right, y down.
struct ContourPoint {
  int x = 0;
  int y = 0;
  friend bool operator==(const ContourPoint&, const ContourPoint&) = default;
};
using Polyline = std::vector<ContourPoint>;

/// Vector outline of a region: the pixels on its outer border and on the border of each of its holes.
struct Contour {
  Polyline outer;
  std::vector<Polyline> holes;
};

/// Plane n . P + d = 0 in the camera frame; the unit normal points towards the camera (n . P < 0, so d > 0).
struct Plane {
  Vec3 normal;
  float d_m = 0;

  float signed_distance_m(Vec3 p) const { return dot(normal, p) + d_m; }
};
/// The same plane seen from its other side: distances change their sign.
inline Plane reversed(const Plane& plane) {
  return {-plane.normal, -plane.d_m};
}

/// 6-DOF pose of a surface in the camera frame (conventions: see surface/pose.hpp).
struct SurfacePose {
  Vec3 centre_m;
  std::array<float, 4> quaternion_wxyz{1, 0, 0, 0};  ///< rotation surface -> camera, w >= 0
  std::array<float, 3> zyx_deg{};                    ///< the same rotation, intrinsic z-y'-x'' angles
  Vec3 rect_axis;  ///< long axis of the contour's minimum-area rectangle, unit
};

/// A grasp with two fingers.
struct Grasp {
  std::array<Vec3, 2> contacts_m;           ///< where the fingers touch, camera frame
  std::array<ImagePoint, 2> contacts_px{};  ///< the same in the image
  Vec3 closing_axis;                        ///< unit, from the first contact to the second
  float width_m = 0;                        ///< distance of the contacts
  float score = 0;                          ///< larger is better
};

/// One segmented surface. `id` is its value in the label image.
struct Surface {
  int id = 0;
  int area_px = 0;
  Contour contour;
  int parent = 0;             ///< id of the surface in whose hole this one lies, 0 = none
  std::vector<int> children;  ///< ids of the surfaces that lie in its holes
  std::optional<Plane> plane;
  float inlier_share = 0;  ///< share of its sampled points within the plane's inlier threshold, 0..1
  float rms_m = 0;         ///< root mean square distance of the inliers to the plane [m]
  bool curved = false;     ///< one plane does not explain it
  std::optional<SurfacePose> pose;
  std::string no_pose_reason;  ///< why `pose` is empty
  bool touches_border = false;
  bool graspable = false;  ///< has a graspable edge on its outline
  std::vector<Grasp> grasps;
  int object = 0;  ///< group of surfaces that the method takes for one object; 0 = it does not group
};

/// A region that the validation dropped.
struct RejectedRegion {
  ContourPoint seed;  ///< first of its pixels in raster order
  int area_px = 0;
  std::string reason;  ///< one of the reasons of surface/validation.hpp
};

}  // namespace facet
