#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "core/image.hpp"
#include "dataset/counted_depth.hpp"

namespace facet {

/// A depth image in metres.
struct DepthImage {
  Image<float> depth_m;  ///< 0 = missing
  CountedDepth counted;  ///< of a 16-bit image, else empty
  std::size_t missing_px = 0;
};

/// Reads a depth image, 16-bit integers or 32-bit floats in one channel (PNG or TIFF), and turns it into
/// metres. Missing depth (0, NaN, infinities, and the raw values `missing_codes`) becomes 0 and is counted.
/// Throws Error{data} naming file and rule: missing or broken file, another pixel type, negative finite
/// depth.
DepthImage read_depth_image(const std::filesystem::path& path, double depth_unit_m,
                            std::span<const double> missing_codes);

}  // namespace facet
