#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>

#include "dataset/dataset.hpp"
#include "prediction/prediction.hpp"

namespace facet {

/// One picture of a frame and what a method made of it, six titled panels: colour, depth, edges by kind,
/// surfaces, contours with pose axes, summary. 8-bit BGR. Throws Error{internal} where the sizes of the
/// images differ.
cv::Mat draw_overlay(const Frame& frame, const Prediction& prediction);

/// Writes that picture to `directory`/FRAME.png.
void write_overlays(const Frame& frame, const Prediction& prediction, const std::filesystem::path& directory);

}  // namespace facet
