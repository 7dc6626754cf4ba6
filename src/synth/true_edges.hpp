#pragma once

#include <vector>

#include "synth/edge_probe.hpp"
#include "synth/scene.hpp"

namespace facet {

/// One visible piece of a physical edge, from geometry.
struct TrueEdge {
  std::uint16_t object_id = 0;  ///< owner, k + 1 for object k
  EdgeKind kind = EdgeKind::none;
  bool graspable = false;  ///< depth or convex, and a finger has room along half of it
  std::array<std::uint16_t, 2>
      faces{};       ///< surface ids of the owner that end here; the second is 0 unless a crease
  ImagePath line{};  ///< its picture, open
  double length_px = 0;
  std::vector<Vec3d> points{};  ///< samples along it, camera frame [m]
  /// Per face and sample, the unit direction in which a finger would press: into the face and along it, or
  /// against its normal where the edge is the silhouette of a round face.
  std::array<std::vector<Vec3d>, 2> inward{};
};

/// How finely curves are walked.
struct EdgeWalk {
  double step_px = 0.5;      ///< distance of the samples
  double bridged_px = 1.5;   ///< a shorter interruption does not split an edge
  double shortest_px = 2.0;  ///< a shorter piece is dropped
  ProbeRule probe{};
};

/// All visible edges of the objects inside the image, in order of object and curve. Exact up to the step.
std::vector<TrueEdge> true_edges(const Scene& scene, const RigidMotion& T_world_camera,
                                 const PosedScene& posed, const Camera& camera, Size size,
                                 const EdgeWalk& walk = {});

}  // namespace facet
