#pragma once

#include "core/camera.hpp"
#include "core/image.hpp"

namespace facet {

/// A quickstart scene as Kinect v1 would see it with that many pixels.
struct BenchScene {
  Camera camera;
  Image<float> depth_m;
};
/// Rendered once per size.
const BenchScene& bench_scene(Size size);

}  // namespace facet
