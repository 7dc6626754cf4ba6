#pragma once

#include <optional>
#include <vector>

#include "core/camera.hpp"
#include "core/image.hpp"
#include "core/rigid_motion.hpp"
#include "prediction/prediction.hpp"

namespace facet {

/// A flat surface with a pose that is followed from frame to frame.
struct TrackedPlane {
  int track = 0;  ///< the same number for the same surface
  Vec3d normal;   ///< towards the camera; in the world where the camera's pose is known, else in the camera
  Vec3d centre_m;
};

/// How a frame's regions agree with those of the frame before it. Needs no truth.
struct FrameStability {
  bool compared = false;  ///< there is a frame before it
  bool in_world = false;  ///< poses of the camera are known: regions are compared where they lie in the scene
  double iou_sum =
      0;            ///< best intersection over union of every region, of both frames, with one of the other
  int regions = 0;  ///< of both frames
  double covered_px = 0;  ///< the same, every region weighed by its pixels
  double region_px = 0;
  int before = 0;  ///< regions of the frame before that this one sees
  int kept = 0;    ///< of these, found again: intersection over union above 0.5
  std::vector<TrackedPlane> planes{};
};

/// A frame and what a method found in it.
struct StabilityInput {
  ImageView<const float> depth_m;  ///< 0 = missing
  Camera camera;
  std::optional<RigidMotion> T_world_camera{};
  const Prediction& prediction;
};

/// Follows the regions of one method through the frames of one sequence.
class StabilityTracker {
 public:
  /// Regions count from this size on [px], after what only one of the frames sees is removed.
  static constexpr int least_region_px = 100;

  FrameStability next(const StabilityInput& frame);
  /// A frame that has no prediction: what follows is not compared with what was before.
  void interrupt() { before_.reset(); }

 private:
  struct Before {
    Image<std::uint16_t> labels;
    Image<float> depth_m;
    Camera camera;
    std::optional<RigidMotion> T_world_camera;
    std::vector<int> tracks;  ///< of each label
  };

  Image<std::uint16_t> labels_before_seen_from(const StabilityInput& frame, bool in_world) const;

  std::optional<Before> before_;
  int next_track_ = 1;
};

}  // namespace facet
