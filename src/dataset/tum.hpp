#pragma once

#include <memory>
#include <span>

#include "dataset/registry.hpp"

namespace facet {

std::span<const OptionInfo> tum_options();

/// Reads a sequence in the layout of the TUM RGB-D benchmark (Sturm et al., IROS 2012): depth.txt and rgb.txt
/// list files by their times, groundtruth.txt has the poses of the camera; depth is value / 5000 m. Colour is
/// that of the nearest time, for one depth image at most. Throws Error{data} where depth.txt is missing or no
/// frame is left.
std::unique_ptr<Dataset> open_tum(const DatasetSpec& spec);

/// Whether a folder has the layout.
bool is_tum(const std::filesystem::path& folder);

}  // namespace facet
