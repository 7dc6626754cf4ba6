#pragma once

#include <array>
#include <map>
#include <opencv2/core/types.hpp>

#include "prediction/prediction.hpp"

namespace facet {

/// Colours [BGR] that people with any common colour vision tell apart (Okabe and Ito 2008, without black).
inline const std::array<cv::Scalar, 7> surface_palette{
    cv::Scalar(0, 159, 230), cv::Scalar(233, 180, 86), cv::Scalar(115, 158, 0),  cv::Scalar(66, 228, 240),
    cv::Scalar(178, 114, 0), cv::Scalar(0, 94, 213),   cv::Scalar(167, 121, 204)};

/// A colour of the palette for every label, different from those of its neighbours wherever the palette
/// suffices. Labels are neighbours where they lie within 4 px of each other in a row or column.
std::map<int, cv::Scalar> surface_colors(const Image<std::uint16_t>& labels);

}  // namespace facet
