#pragma once

#include <memory>
#include <span>

#include "dataset/registry.hpp"

namespace facet {

std::span<const OptionInfo> osd_options();

/// Reads the layout of OSD-0.2 below `spec.root`: image_color/ID.png, disparity/ID.png (which holds depth in
/// mm), annotation/ID.png (object masks, optional); pcd/ is not read. Colour and depth are registered to each
/// other. The data set has no intrinsics of its own: 525 525 319.5 239.5 is assumed unless the options say
/// otherwise.
std::unique_ptr<Dataset> open_osd(const DatasetSpec& spec);

}  // namespace facet
