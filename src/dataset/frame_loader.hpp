#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dataset/dataset.hpp"

namespace facet {

/// Where the images of one frame are; colour and masks only where they fit the depth image pixel by pixel.
struct FrameFiles {
  std::filesystem::path depth;
  std::optional<std::filesystem::path> color = std::nullopt;
  std::optional<std::filesystem::path> object_masks = std::nullopt;
};

/// What the numbers of a depth image mean.
struct DepthFormat {
  double unit_m = 0.001;                ///< metres per unit
  std::vector<double> missing_codes{};  ///< raw values that mean missing depth, beside 0, NaN and infinities
};

/// Reads and checks one frame; throws Error{data} that names every broken file of it and the rule.
Frame load_frame(const std::string& id, const FrameFiles& files, const DepthFormat& format,
                 const Camera& camera);

}  // namespace facet
