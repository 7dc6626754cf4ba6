#pragma once

#include "synth/synthetic_frame.hpp"

namespace facet {

/// A quickstart scene as Kinect v1 sees it with fewer pixels, so that slow executors finish soon. Any size.
inline Image<float> small_measured_scene(std::size_t index, Size size, const Camera& camera,
                                         std::uint64_t seed) {
  const View view = quickstart_views(1)[index];
  return measure({}, render(PosedScene(view.scene, view.T_world_camera), camera, size), camera, seed);
}

/// A camera with the field of view of Kinect v1 for another image size.
inline Camera scaled_camera(Size size) {
  const float scale = static_cast<float>(size.width) / 640;
  return {525 * scale, 525 * scale, static_cast<float>(size.width - 1) / 2,
          static_cast<float>(size.height - 1) / 2};
}

}  // namespace facet
