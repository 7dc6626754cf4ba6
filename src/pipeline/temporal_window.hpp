#pragma once

#include "pipeline/temporal_gate.hpp"

namespace facet {

/// The frames that may be averaged with the current one, on the executor's side.
template <class Executor>
class TemporalWindow {
 public:
  /// Takes a frame in; forgets those before it where it does not belong to them.
  void take(Executor& executor, const TemporalParams& params, const DepthNoise& noise,
            const FrameInput& frame) {
    gate_.admit(frame, params, noise);
    if (gate_.use().start != WindowStart::continued) history_.clear();
    history_.push(executor, frame.depth_m, params.frames, frame.counts);
  }
  void clear() {
    history_.clear();
    gate_.clear();
  }
  const TemporalHistory<Executor>& frames() const { return history_; }
  const WindowUse& use() const { return gate_.use(); }

 private:
  TemporalHistory<Executor> history_;
  TemporalGate gate_;
};

}  // namespace facet
