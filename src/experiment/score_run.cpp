#include "experiment/score_run.hpp"

#include "core/error.hpp"
#include "experiment/dataset_text.hpp"
#include "file/file_bytes.hpp"

namespace facet {

Experiment score_experiment(const ScoreRequest& request) {
  Experiment experiment;
  experiment.name = "score";
  experiment.datasets = {dataset_called(request.dataset)};
  if (request.annotations) experiment.datasets.front().annotations = *request.annotations;
  MethodSpec method;
  const std::string name = std::filesystem::weakly_canonical(request.predictions).filename().string();
  method.name = is_plain_name(name) ? name : "predictions";
  method.kind = "predictions";
  method.folder = request.predictions;
  experiment.methods = {method};
  experiment.timing.repeats = 0;
  experiment.outputs.predictions = false;
  return experiment;
}

RunOutcome score_predictions(const ScoreRequest& request, const RunOptions& options, RunObserver& observer,
                             const std::atomic<int>& stop_signal) {
  if (!std::filesystem::is_directory(request.predictions))
    throw Error(ErrorKind::data, printable(request.predictions) + ": folder is missing");
  return run_experiment(score_experiment(request), options, observer, stop_signal);
}

}  // namespace facet
