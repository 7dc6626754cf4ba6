#pragma once

#include "pipeline/params.hpp"
#include "pipeline/result.hpp"
#include "pipeline/stage_range.hpp"

namespace facet {

/// The segmentation pipeline on one back end. Keeps its buffers, and the past frames of the temporal average,
/// between calls: one object per thread and per sequence.
class Pipeline {
 public:
  virtual ~Pipeline() = default;
  /// Segments one frame. `result` keeps its memory between calls. Throws Error{data} where depth is negative
  /// or the camera cannot be right.
  void process(const FrameInput& frame, FrameResult& result) { run(all_stages, frame, result); }
  /// The same in several calls, maybe from different threads: all stages in order with the same frame and
  /// result, before the first stage of the next frame.
  virtual void run(StageRange stages, const FrameInput& frame, FrameResult& result) = 0;
  /// Forgets past frames (start of another sequence).
  virtual void reset_history() = 0;
};

}  // namespace facet
