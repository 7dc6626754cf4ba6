#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/image.hpp"
#include "core/window_use.hpp"
#include "surface/surface.hpp"

namespace facet {

/// Reason of an absent pose where the prediction says nothing of poses.
inline constexpr const char* pose_not_provided = "not provided";

/// A grasp of a method that finds no surfaces: the hand stands in the middle between the contacts, its y axis
/// is the closing axis and its z axis the approach axis.
struct FreeGrasp {
  Grasp grasp;
  Vec3 approach_axis;  ///< unit, away from the camera
};

/// What a method yields for one frame: the meeting place of methods, files and scores.
struct Prediction {
  Image<std::uint16_t> labels;  ///< 0 = no surface, k = the surface with id k
  Image<std::uint8_t> edges;    ///< EdgeKind, + graspable_edge_bit; empty where a method yields no edges
  std::vector<Surface> surfaces;
  std::vector<RejectedRegion> rejected;
  std::vector<FreeGrasp> grasps;  ///< those that belong to no surface, best first
  std::string note;               ///< why there is no surface at all, empty otherwise
  WindowUse window;               ///< frames it was made from; not stored
};

}  // namespace facet
