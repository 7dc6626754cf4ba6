#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "core/image_view.hpp"

namespace facet {

/// A mode of the Azure Kinect's depth camera: its image is a part, cropped after binning, of the sensor's.
struct AzureDepthMode {
  std::string_view name;
  Size size;
  int binned_px;       ///< side of the whole sensor after binning
  int crop_x, crop_y;  ///< first column and row of the image [px]
};

/// The modes that measure depth; all of them differ in size.
std::span<const AzureDepthMode> azure_depth_modes();

/// Nothing where there is no such mode.
const AzureDepthMode* azure_mode_of_size(Size size);

}  // namespace facet
