#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "dataset/dataset.hpp"
#include "prediction/prediction.hpp"

namespace facet {

/// What one variant of a method made of a frame.
struct StripStep {
  std::string title;
  Prediction prediction;
};

/// The steps side by side in the manner of the paper's figure 5: edges by kind above, surfaces below, in half
/// the size of other pictures. 8-bit BGR. Needs one step at least.
cv::Mat draw_strip(const Frame& frame, const std::vector<StripStep>& steps);

}  // namespace facet
