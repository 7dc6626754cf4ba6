#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <memory>

#include "pipeline/pipeline.hpp"

namespace facet {

using StreamClock = std::chrono::steady_clock;

/// The stages' memory for one frame on its way, and what they find in it.
struct Workspace {
  std::unique_ptr<Pipeline> pipeline;
  FrameResult result;
};

/// What a filter cost one frame.
struct FilterTimes {
  double work_ms = 0;  ///< wall time
  double cpu_ms = 0;   ///< of the filter's thread
};

/// A frame on its way from the producer through the filters to the sink.
struct Passage {
  std::size_t number = 0;             ///< among the frames that were offered, from 0
  const FrameInput* frame = nullptr;  ///< outlives the stream
  StreamClock::time_point due;        ///< when the sensor had it
  StreamClock::time_point entered;    ///< when the first filter took it
  std::unique_ptr<Workspace> workspace;
  std::array<FilterTimes, stage_count> filters{};
};

}  // namespace facet
