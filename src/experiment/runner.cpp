#include "experiment/runner.hpp"

#include <algorithm>
#include <opencv2/core/utility.hpp>
#include <tbb/global_control.h>

#include "experiment/experiment_run.hpp"
#include "method/registry.hpp"

namespace facet {

namespace {

/// Other methods than the pipeline run on the CPU, whatever was asked for.
BackendChoice backend_of(const Experiment& experiment, const RunOptions& options) {
  const BackendChoice choice = choose_backend(options.backend);
  const bool has_pipeline = std::any_of(experiment.methods.begin(), experiment.methods.end(),
                                        [](const MethodSpec& spec) { return spec.kind == "pipeline"; });
  return has_pipeline ? choice : BackendChoice{Backend::cpu, "no method is a pipeline"};
}

}  // namespace

Plan check_experiment(const Experiment& experiment, const RunOptions& options) {
  const BackendChoice backend = backend_of(experiment, options);
  // What is wrong with a method is said before anything is computed.
  for (const MethodSpec& spec : experiment.methods) make_method(spec, {});
  Plan plan = make_plan(experiment, options);
  plan.backend = backend;
  return plan;
}

RunOutcome run_experiment(const Experiment& experiment, const RunOptions& options, RunObserver& observer,
                          const std::atomic<int>& stop_signal) {
  // Parallelism is over frames, and a timed run uses the threads it reports: OpenCV adds none of its own.
  cv::setNumThreads(1);
  const auto threads = static_cast<std::size_t>(std::max(options.jobs, experiment.timing.threads));
  const tbb::global_control parallelism(tbb::global_control::max_allowed_parallelism, threads);
  return ExperimentRun(experiment, options, observer, stop_signal).execute();
}

RunOutcome run_experiment(const RunOptions& options, RunObserver& observer,
                          const std::atomic<int>& stop_signal) {
  return run_experiment(load_experiment(options.config_file, options.overrides).experiment, options, observer,
                        stop_signal);
}

}  // namespace facet
