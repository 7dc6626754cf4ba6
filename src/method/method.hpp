#pragma once

#include "dataset/dataset.hpp"
#include "pipeline/result.hpp"
#include "prediction/prediction.hpp"

namespace facet {

/// Something that can be evaluated: one frame in, one prediction out. Keeps buffers between calls, and for a
/// sequence its past: one object per thread, and per sequence.
class Method {
 public:
  virtual ~Method() = default;
  /// `prediction` keeps its memory between calls; `times` is overwritten. Throws Error{data} where the frame
  /// cannot be processed.
  virtual void process(const Frame& frame, Prediction& prediction, StageTimes& times) = 0;
  /// Forgets past frames.
  virtual void reset_history() = 0;
};

}  // namespace facet
