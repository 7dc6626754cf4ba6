#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "synth/kinect_v1.hpp"
#include "synth/quickstart.hpp"

namespace facet {

/// Which built-in frames to make.
struct SyntheticSpec {
  std::string scenes = "quickstart";  ///< a name of synthetic_scene_sets()
  std::uint64_t seed = 1;             ///< of layout and sensor noise
  bool noise_free = false;            ///< true: the exact depth instead of a Kinect v1 measurement
  KinectV1 sensor{.registration_border = false};
};

/// One rendered and measured frame. All images have the same size.
struct SyntheticFrame {
  std::string id{};
  View view{};
  Camera camera{};
  Rendering exact{};       ///< what an ideal camera sees
  Image<float> depth_m{};  ///< what the sensor reports, 0 = missing
};

/// Names that SyntheticSpec::scenes takes.
std::vector<std::string> synthetic_scene_sets();
/// Ids of the frames of a spec, in order; Error{config} for an unknown scene set.
std::vector<std::string> frame_ids(const SyntheticSpec& spec);
/// Renders and measures frame `index`; depends on the arguments alone and may be called from several threads.
SyntheticFrame make_frame(const SyntheticSpec& spec, std::size_t index);

}  // namespace facet
