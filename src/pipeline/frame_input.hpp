#pragma once

#include <optional>

#include "core/camera.hpp"
#include "core/depth_counts.hpp"
#include "core/image_view.hpp"
#include "core/rigid_motion.hpp"

namespace facet {

/// Input of the pipeline: one decoded depth frame.
struct FrameInput {
  ImageView<const float> depth_m;  ///< metres along the optical axis, 0 = missing
  Camera camera;
  std::optional<double> timestamp_s{};          ///< where it is known
  std::optional<RigidMotion> T_world_camera{};  ///< where it is known
  std::optional<DepthCounts> counts{};  ///< depth_m in whole units, where it came so: see upload_depth()
};

}  // namespace facet
