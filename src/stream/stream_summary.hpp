#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/timing_summary.hpp"
#include "stream/stream_record.hpp"

namespace facet {

/// Times of one part of the way through a stream.
struct StreamTimes {
  std::string name;
  int threads = 0;      ///< frames at a time; 0 where that has no meaning
  TimeStatistics wall;  ///< of the frames that count
  std::optional<double> cpu_mean_ms;
};

/// The frames of a record that count, in figures.
struct StreamSummary {
  std::vector<StreamTimes> filters;
  StreamTimes pass;     ///< from the first filter's start to the sink, queues between filters included
  StreamTimes latency;  ///< from when a frame was due to the sink
  std::vector<StreamTimes> stages;
  double throughput_hz = 0;
  /// Processor time of all filters for one frame, and the most frames per second that the cores could process
  /// if nothing else ran on them.
  std::optional<double> cpu_per_frame_ms, most_hz;
  /// All offered frames were processed and found room before the next one was due; nothing where frames were
  /// offered as fast as they were taken.
  std::optional<bool> is_sustained;
};

StreamSummary summarize(const StreamRecord& record);

}  // namespace facet
