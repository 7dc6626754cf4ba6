#pragma once

#include <atomic>
#include <vector>

#include "experiment/accuracy_pass.hpp"
#include "experiment/earlier_points.hpp"
#include "experiment/run_directory.hpp"
#include "experiment/runner.hpp"
#include "record/manifest.hpp"

namespace facet {

/// One run, from its plan to its report.
class ExperimentRun {
 public:
  ExperimentRun(const Experiment& experiment, const RunOptions& options, RunObserver& observer,
                const std::atomic<int>& stop_signal);
  RunOutcome execute();

 private:
  RunDirectory open_directory();
  void describe_run();
  void note_gaps();
  int failed() const { return manifest_.frames_data_error + manifest_.frames_method_error; }
  void publish_results(const AccuracyPass& pass, bool stopped_early);
  void adopt_points();
  void publish_galleries();
  void publish_strips();
  void publish_program_times(const AccuracyPass& pass);
  void time_methods(const AccuracyPass& pass);
  int exit_code(bool stopped_early) const;
  RunOutcome finish(bool stopped_early);

  const Experiment& source_;     ///< as it is written
  const Experiment experiment_;  ///< with the methods of its study
  const RunOptions& options_;
  RunObserver& observer_;
  const std::atomic<int>& stop_signal_;
  Plan plan_;
  RunIdentity identity_;
  RunDirectory directory_;
  Manifest manifest_;
  std::vector<FrameRow> rows_;
  EarlierPoints adopted_;
};

}  // namespace facet
