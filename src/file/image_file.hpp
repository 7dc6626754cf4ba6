#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <optional>

#include "file/png_structure.hpp"

namespace facet {

/// An image as it stands in its file: type, channels and bit depth unchanged.
struct ImageFile {
  cv::Mat pixels;
  std::optional<PngHeader> png;  ///< where the file is a PNG
};

/// Reads an image without any conversion. Throws Error{data} naming file and rule where it is missing,
/// truncated, corrupt, or of a format that cannot be decoded.
ImageFile read_image_file(const std::filesystem::path& path);

/// The least time is a third of the other's for pictures, which then take a fifth more space, and a tenth for
/// label images, which take twice the space.
enum class PngEffort { least_space, least_time };

/// Writes a PNG (8-bit or 16-bit, 1 or 3 channels) atomically; the same pixels give the same bytes.
void write_png_file(const std::filesystem::path& path, const cv::Mat& pixels,
                    PngEffort effort = PngEffort::least_space);

}  // namespace facet
