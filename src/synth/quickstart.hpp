#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/camera.hpp"
#include "core/image_view.hpp"
#include "synth/scene.hpp"

namespace facet {

/// A scene with the camera that looks at it.
struct View {
  std::string name;
  Scene scene{};
  RigidMotion T_world_camera{};
};

/// Camera at `eye` looking at `target`, the image's up along world z. World frame [m].
RigidMotion look_at(Vec3d eye, Vec3d target);

/// Kinect v1 at 640x480, the usual assumption for OSD.
inline Size kinect_v1_size() {
  return {640, 480};
}
inline Camera kinect_v1_camera() {
  return {525.0f, 525.0f, 319.5f, 239.5f};
}

/// Six table-top scenes seen from about 0.9 m away: box, boxes, stacked boxes, cylinders, mixed, occluded.
/// Camera and objects are varied a little by the seed.
std::vector<View> quickstart_views(std::uint64_t seed);
/// A box on a table without anything else, for tests: the smallest scene with every kind of edge.
View plane_and_box_view();

}  // namespace facet
