#pragma once

#include <array>
#include <vector>

#include "core/depth_noise.hpp"
#include "core/image.hpp"
#include "pipeline/frame_input.hpp"

namespace facet {

/// How far the camera has moved since a frame, measured by what that does to the depths: the root mean square
/// of their coherent change, in deviations of the sensor's noise. That is what an average over both frames
/// would blur. With the pose of the camera it follows from the pose; without it, the motion is fitted to the
/// change of depth itself, linearly (cf. Horn and Weldon, IJCV 1988). Works on means over blocks of pixels,
/// so that neither the noise of single readings nor jumps within a block stand against the linear model.
class CameraMotion {
 public:
  /// Forgets the former frame and remembers this one.
  void start_from(const FrameInput& frame, const DepthNoise& noise);
  /// The change since that frame, of the same size; what noise alone would show is not counted. Infinite
  /// where the frames have too little in common to be compared.
  double change_sigmas(const FrameInput& frame);

 private:
  struct Block {
    int x = 0, y = 0;  ///< in the image of means
    double depth_m = 0;
    double per_sigma = 0;            ///< 1 / deviation of the difference of two readings [1/m]
    std::array<double, 6> response;  ///< change [sigma] per motion: translation [1/m], rotation [1/rad]
  };
  struct Change {
    const Block* block;
    double sigmas;
  };

  void add_block(const Camera& camera, const DepthNoise& noise, int x, int y);
  double change_by_pose(const RigidMotion& T_start_now) const;
  double change_by_depth(const FrameInput& frame);

  int side_px_ = 1;  ///< of the blocks
  Image<float> means_m_;
  std::vector<Block> blocks_;
  std::vector<Change> changes_;  ///< scratch
  std::optional<RigidMotion> T_world_camera_;
};

}  // namespace facet
