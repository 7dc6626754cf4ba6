#pragma once

#include <cstdint>
#include <filesystem>
#include <opencv2/core/mat.hpp>

#include "prediction/prediction.hpp"

namespace facet {

/// OpenCV's view of an image; shares its memory and must not be written through.
cv::Mat as_mat(const Image<std::uint16_t>& image);
cv::Mat as_mat(const Image<std::uint8_t>& image);

/// Reads a label image: 8-bit or 16-bit grey PNG. Throws Error{data} naming file and rule.
Image<std::uint16_t> read_label_image(const std::filesystem::path& path);

/// Throws Error{data} where the label image of a file is not of its frame's size.
void require_size(const std::filesystem::path& path, Size labels, Size frame);

/// Reads an edge image of that size: 8-bit grey PNG of known codes. Throws Error{data} naming file and rule.
Image<std::uint8_t> read_edge_image(const std::filesystem::path& path, Size size);

/// Checks the surfaces of a prediction against its label image, adds one for every label that has none, sorts
/// them by id and sets what the label image tells: area_px and touches_border. Throws Error{data} (`path`
/// opens the message) where an id stands twice or nowhere in the label image, or a stated area is not the
/// label's.
void complete_surfaces(const std::filesystem::path& path, Prediction& prediction);

}  // namespace facet
