#pragma once

#include <atomic>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "experiment/plan.hpp"
#include "experiment/run_observer.hpp"
#include "record/timing_row.hpp"

namespace facet {

/// What the timing pass measured.
struct Timings {
  TimingTable table;
  std::vector<IoTime> io_times;  ///< decoding, and the calibration block beside the timed runs
};

/// (data set, frame, method) as they stand in the rows.
using FrameKeys = std::set<std::tuple<std::string, std::string, std::string>>;

/// Times every method over every frame in `frames`, nothing else running: timing.warmup runs that do not
/// count, then timing.repeats that do; a still frame's runs follow each other, a sequence is run through as
/// often. Returns early, with what there is, once `stop_signal` is not 0.
Timings run_timing_pass(const Experiment& experiment, const Plan& plan, const FrameKeys& frames,
                        RunObserver& observer, const std::atomic<int>& stop_signal);

}  // namespace facet
