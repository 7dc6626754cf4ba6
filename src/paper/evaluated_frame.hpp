#pragma once

#include "experiment/gallery_pictures.hpp"
#include "paper/reproduction.hpp"
#include "score/frame_score.hpp"

namespace facet {

/// A frame that a method was run on, for a figure, and its score where there is truth.
struct EvaluatedFrame {
  FrameAgain frame;
  std::optional<FrameScore> score;

  /// "default: 12 of 14 surfaces", "naive: 250 regions" without truth.
  std::string caption(const std::string& method) const;
};

/// Frame `index` of a data set under a method, both by name. Throws Error{internal} for unknown names.
EvaluatedFrame evaluate(const std::pair<Experiment, Plan>& planned, const std::string& dataset,
                        std::size_t index, const std::string& method);

/// Surfaces in their colours with a title.
cv::Mat surfaces_panel(const EvaluatedFrame& evaluated, const std::string& title);
/// Colour image with a title; depth in grey where there is none.
cv::Mat color_panel(const EvaluatedFrame& evaluated, const std::string& title);

}  // namespace facet
