#pragma once

#include <array>
#include <optional>

#include "core/image_point.hpp"
#include "surface/surface.hpp"
#include "synth/posed_scene.hpp"

namespace facet {

/// How rays on both sides of a point of a curve tell what kind of edge is seen there.
struct ProbeRule {
  double offset_px = 0.05;  ///< distance of the two rays from the curve
  double contact_gap_m =
      0.003;  ///< a smaller step in depth is contact, not a depth edge: one step of Kinect v1 at 1 m
  double crease_min_cos = 0.98480775;  ///< cosine of 10 deg: a flatter meeting of surfaces is no edge
  double finger_m = 0.010;             ///< thickness of a finger beside the edge
  double finger_depth_m = 0.005;       ///< how far behind the edge a finger must reach
};

/// A point of a curve in space with the patches that meet there and the direction of its picture.
struct CurvePoint {
  Vec3d point;                           ///< camera frame [m]
  ImagePoint image{};                    ///< its picture
  ImagePoint tangent{};                  ///< unit direction of the curve's picture
  std::size_t patch_a = 0, patch_b = 0;  ///< indices in the posed scene; equal where there is only one
};

/// What is seen at a point of a curve. `own` are the surfaces of the owner that end there: one at a depth
/// edge or a contact, two (ascending) at a crease.
struct EdgeSample {
  EdgeKind kind = EdgeKind::none;
  std::array<std::uint16_t, 2> own{};
  std::array<Vec3d, 2> own_normals{};  ///< of the faces `own` at the point, towards the camera
  std::array<bool, 2> own_on_side{};   ///< the owner's surface is seen right, left of the curve's direction
  bool first_face_right = false;       ///< own[0] lies right of the curve's direction
  bool reachable = false;              ///< by a finger
};

/// Casts rays just beside the point. `none` where the curve is hidden, or the surfaces meet smoothly.
EdgeSample probe_edge(const PosedScene& scene, const Camera& camera, const CurvePoint& at,
                      const ProbeRule& rule);

}  // namespace facet
