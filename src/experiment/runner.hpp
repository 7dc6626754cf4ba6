#pragma once

#include <atomic>
#include <filesystem>

#include "experiment/experiment_reader.hpp"
#include "experiment/plan.hpp"
#include "experiment/run_observer.hpp"
#include "experiment/run_options.hpp"
#include "report/document.hpp"

namespace facet {

/// How a run ended.
struct RunOutcome {
  int exit_code = 0;
  std::filesystem::path directory;
  Report report;  ///< empty where the run was interrupted
};

/// Runs an experiment: accuracy pass, timing pass, run directory and report. A signal number in `stop_signal`
/// ends it at the next frame, so that `resume` completes it later. Failed frames do not throw; they decide
/// the exit code. Throws Error{config} for sections that are not built, Error{not_measured} for a back end
/// that is not there.
RunOutcome run_experiment(const Experiment& experiment, const RunOptions& options, RunObserver& observer,
                          const std::atomic<int>& stop_signal);
/// The same for the experiment file that the options name.
RunOutcome run_experiment(const RunOptions& options, RunObserver& observer,
                          const std::atomic<int>& stop_signal);

/// Throws as run_experiment() does where it could not start; nothing is written.
Plan check_experiment(const Experiment& experiment, const RunOptions& options);

}  // namespace facet
