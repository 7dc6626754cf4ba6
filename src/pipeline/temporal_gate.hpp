#pragma once

#include <array>
#include <optional>

#include "core/depth_noise.hpp"
#include "core/window_use.hpp"
#include "pipeline/camera_motion.hpp"
#include "stage/temporal_average.hpp"

namespace facet {

/// Decides which frames may be averaged: a window ends with a gap in time, and when the camera moves.
class TemporalGate {
 public:
  /// Lets a frame in; `use().start` tells whether the frames before it must be forgotten.
  void admit(const FrameInput& frame, const TemporalParams& params, const DepthNoise& noise);
  void clear() { count_ = 0; }
  const WindowUse& use() const { return use_; }

 private:
  WindowStart judge(const FrameInput& frame, const TemporalParams& params);
  std::optional<double> mean_age_s() const;

  int count_ = 0;  ///< frames of the window
  Size size_;
  std::array<std::optional<double>, max_temporal_frames> times_s_{};  ///< of the window, the latest first
  CameraMotion motion_;
  int since_start_ = 0;  ///< frames since that from which motion is measured
  WindowUse use_;
};

}  // namespace facet
