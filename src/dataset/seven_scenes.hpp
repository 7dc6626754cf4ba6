#pragma once

#include <memory>
#include <span>

#include "dataset/registry.hpp"

namespace facet {

std::span<const OptionInfo> seven_scenes_options();

/// Reads a sequence in the layout of 7-Scenes (Shotton et al., CVPR 2013): frame-NUMBER.depth.png in mm,
/// 65535 = missing, .pose.txt with the pose of the camera as a 4x4 matrix, .color.png, which is not
/// registered. Numbers count frames at 30 Hz. Throws Error{data} where the folder is missing or holds no
/// frame.
std::unique_ptr<Dataset> open_seven_scenes(const DatasetSpec& spec);

/// Whether a folder has the layout.
bool is_seven_scenes(const std::filesystem::path& folder);

}  // namespace facet
