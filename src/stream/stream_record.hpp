#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "pipeline/result.hpp"
#include "stream/bounded_queue.hpp"
#include "stream/machine_load.hpp"
#include "stream/passage.hpp"
#include "stream/stream_options.hpp"

namespace facet {

/// One frame that has left the filters.
struct StreamSample {
  std::size_t number = 0;  ///< among the offered frames
  double done_s = 0;       ///< since the stream's start
  double latency_ms = 0;   ///< from when it was due to its result
  double pass_ms = 0;      ///< from when the first filter took it
  int surfaces = 0;
  std::array<FilterTimes, stage_count> filters{};
  StageTimes stages;
};

/// Resident memory of the process [MB], from the first frame after warm-up on.
struct MemoryUse {
  double after_warmup_mb = 0;
  double max_mb = 0;
  double end_mb = 0;
};

/// What one method did with one stream of frames.
struct StreamRecord {
  std::string dataset, method;
  StreamOptions options;
  std::size_t frames_in_memory = 0;
  int threads_in_frame = 1;
  std::vector<StreamSample> samples;  ///< in the order in which they left; warm-up first
  std::vector<QueueStatistics> queues;
  std::size_t due = 0;  ///< frames that the sensor had: offered, or without a chance to be
  std::size_t offered = 0;
  std::size_t late = 0;  ///< of the offered: those that found room only when the next one was due
  MemoryUse memory;
  MachineLoad load;
  bool interrupted = false;

  /// Where the samples that count begin.
  std::size_t first_counted() const;
  /// Frames per second that left after warm-up; 0 where that were fewer than two.
  double throughput_hz() const;
  std::size_t dropped() const { return queues.empty() ? 0 : queues.front().dropped; }
};

}  // namespace facet
