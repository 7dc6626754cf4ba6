#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/camera.hpp"
#include "core/image.hpp"
#include "pipeline/frame_input.hpp"

namespace facet {

/// A frame as a depth camera delivers it: 16-bit units, 0 = missing.
struct RawFrame {
  std::string name;
  Image<std::uint16_t> depth;
  double unit_m = 0.001;
  Camera camera;
};

/// Metres of a raw frame; `depth_m` keeps its memory.
void decode(const RawFrame& frame, Image<float>& depth_m);

/// The raw frame and its metres as a pipeline takes them.
FrameInput input_of(const RawFrame& frame, const Image<float>& depth_m);

/// Rendered table-tops as Kinect v1 would see them with that many pixels, in millimetres.
std::vector<RawFrame> render_raw_frames(Size size, int count);

/// A folder of raw frames: NAME.u16, little-endian, row by row without padding, and frames.json with the
/// size, unit and camera of each. Throws Error{internal} where it cannot be written.
void write_raw_frames(const std::filesystem::path& folder, const std::vector<RawFrame>& frames);

/// Throws Error{data} for a missing or broken file, with its name.
std::vector<RawFrame> read_raw_frames(const std::filesystem::path& folder);

}  // namespace facet
