#pragma once

#include <string>
#include <string_view>

#include "dataset/azure_depth_mode.hpp"
#include "dataset/lens.hpp"

namespace facet {

/// The depth camera as the calibration.json of a recording describes it, in the pixels of the mode's image.
/// Throws Error{data}, opened by `context`, where the text is no calibration of a depth camera with 14 or 15
/// finite parameters.
LensModel azure_depth_lens(std::string_view json, const AzureDepthMode& mode, const std::string& context);

}  // namespace facet
