#pragma once

#include "prediction/prediction.hpp"
#include "score/frame_truth.hpp"

namespace facet {

/// The prediction of a perfect method, which scores 100 % everywhere: every surface that counts as a region
/// with its object (of object masks alone: every object), edges drawn along their lines, the true poses
/// (where they are not known, any valid one), and for every graspable surface a grasp between two of its
/// graspable edges.
Prediction truth_as_prediction(const FrameTruth& frame);

}  // namespace facet
