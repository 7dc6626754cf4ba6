#pragma once

#include "pipeline/pipeline_body.hpp"
#include "pipeline/small_scene.hpp"

namespace facet {

/// What `process(frame, result)` makes of the last of three frames of a scene: the temporal average sees a
/// past.
template <class Process>
FrameResult last_of_three(Size size, const Process& process) {
  const Camera camera = scaled_camera(size);
  FrameResult result;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Image<float> depth = small_measured_scene(4, size, camera, seed);
    process(FrameInput{depth.view(), camera}, result);
  }
  return result;
}

inline FrameResult last_of_three(Size size, Pipeline& pipeline) {
  return last_of_three(
      size, [&](const FrameInput& frame, FrameResult& result) { pipeline.process(frame, result); });
}

}  // namespace facet
