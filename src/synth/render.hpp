#pragma once

#include <cstdint>

#include "core/image.hpp"
#include "synth/posed_scene.hpp"

namespace facet {

/// What an ideal camera sees of a scene: one ray through every pixel centre.
struct Rendering {
  Image<float> depth_m;              ///< along the optical axis, 0 = nothing hit
  Image<std::uint16_t> surface_ids;  ///< see first_face_id()
  Image<std::uint16_t> object_ids;   ///< 0: table, room or nothing; k + 1: object k
  Image<Vec3> normals;               ///< unit, towards the camera, camera frame; zero where nothing was hit
  Image<Rgb> colour;                 ///< shaded
};

/// Renders by analytic ray casting; the result depends on nothing but the arguments.
Rendering render(const PosedScene& scene, const Camera& camera, Size size);

}  // namespace facet
