#pragma once

#include "experiment/runner.hpp"

namespace facet {

/// Streams the frames of every data set of an experiment through every one of its methods, as its section
/// `stream` says: frames are read into memory first, and no result is written, only what was measured.
/// `options` says nothing of jobs, shards and resuming here. A signal number in `stop_signal` ends it; what
/// was measured until then is reported. Throws Error{config} for a method that is no pipeline,
/// Error{not_measured} where all frames would be warm-up, and what a stage has thrown.
RunOutcome run_stream_experiment(const RunOptions& options, RunObserver& observer,
                                 const std::atomic<int>& stop_signal);

}  // namespace facet
