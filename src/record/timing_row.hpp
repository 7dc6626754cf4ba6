#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace facet {

/// `first`: the very first run of a method on a data set, which pays for allocation. `warmup`: the runs of a
/// frame before those that count. `steady`: those that count.
enum class TimingPhase { first, warmup, steady };

/// Times of one run over one frame.
struct TimingSample {
  std::string dataset;
  std::string frame;
  std::string method;
  TimingPhase phase = TimingPhase::steady;
  int repeat = 0;
  int surfaces = 0;
  int posed = 0;
  double total_ms = 0;             ///< decoded depth in memory to contours, poses and labels in memory
  std::vector<double> stage_ms{};  ///< in the order of TimingTable::stages; empty: the method has none
};

/// timing/samples.csv.
struct TimingTable {
  std::vector<std::string> stages;  ///< keys, in order of execution
  std::vector<TimingSample> samples;
};

/// Time outside the method: `decode` of a frame, `write` of its outputs, the `calibration` block between
/// timed runs.
struct IoTime {
  std::string dataset;
  std::string frame;
  std::string method;  ///< empty for decoding
  std::string what;
  double ms = 0;
};

std::string to_csv(const TimingTable& table);
std::string to_csv(const std::vector<IoTime>& times);
/// Throw Error{data} where a row does not fit its header.
TimingTable timing_from_csv(std::string_view text);
std::vector<IoTime> io_times_from_csv(std::string_view text);

}  // namespace facet
