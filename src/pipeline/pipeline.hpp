#pragma once

#include "pipeline/params.hpp"
#include "pipeline/result.hpp"

namespace facet {

/// The segmentation pipeline on one back end. Keeps its buffers, and the past frames of the temporal average,
/// between calls: one object per thread and per sequence.
class Pipeline {
 public:
  virtual ~Pipeline() = default;
  /// Segments one frame. `result` keeps its memory between calls. Throws Error{data} where depth is negative
  /// or the camera cannot be right.
  virtual void process(const FrameInput& frame, FrameResult& result) = 0;
  /// Forgets past frames (start of another sequence).
  virtual void reset_history() = 0;
};

}  // namespace facet
