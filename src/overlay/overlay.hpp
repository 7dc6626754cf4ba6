#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <optional>

#include "dataset/dataset.hpp"
#include "prediction/prediction.hpp"

namespace facet {

/// One picture of a frame and what a method made of it, six titled panels: colour, depth, edges by kind,
/// surfaces, contours with pose axes, summary. 8-bit BGR. Throws Error{internal} where the sizes of the
/// images differ.
cv::Mat draw_overlay(const Frame& frame, const Prediction& prediction);

/// The same in four panels, to see where a prediction is wrong: colour, edges, surfaces, and the surfaces of
/// the truth where it is known (otherwise depth).
cv::Mat draw_comparison(const Frame& frame, const Prediction& prediction,
                        const std::optional<Prediction>& truth);

/// Writes the first picture to `directory`/FRAME.png.
void write_overlays(const Frame& frame, const Prediction& prediction, const std::filesystem::path& directory);

}  // namespace facet
