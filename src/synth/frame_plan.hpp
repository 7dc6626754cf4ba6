#pragma once

#include "synth/layout.hpp"
#include "synth/set_spec.hpp"

namespace facet {

/// One frame that a set holds.
struct PlannedFrame {
  std::string id;          ///< unique within the sequence or, without sequences, within the set
  std::string sequence{};  ///< name of the sequence it belongs to, empty without sequences
  int scene = 0, frame = 0;
  double level = 0;             ///< value of what the set varies
  std::string not_available{};  ///< why there is no such frame: "n/a (range)"; empty otherwise
};

/// All frames of the set in order. Error{config} naming the key where the spec is impossible.
std::vector<PlannedFrame> plan_frames(const SetSpec& spec);

/// A rendered and measured frame of a set. Its scene is the same for all frames of a sequence.
struct PlannedPicture {
  View view{};
  Camera camera{};
  Rendering exact{};
  Image<float> depth_m{};  ///< as measured, 0 = missing
  int objects_requested = 0;
  double timestamp_s = 0;
};

/// Where the camera of a frame stands, and when.
struct PlannedPose {
  double timestamp_s = 0;
  RigidMotion T_world_camera{};
};
PlannedPose planned_pose(const SetSpec& spec, const PlannedFrame& planned);

/// Makes one frame; depends on the arguments alone and may be called from several threads.
PlannedPicture make_planned(const SetSpec& spec, const PlannedFrame& planned);

}  // namespace facet
