#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>

#include "experiment/runner.hpp"

namespace facet {

/// What `facet score` is told.
struct ScoreRequest {
  std::filesystem::path predictions;                 ///< folder of FRAME.labels.png and the like
  std::string dataset;                               ///< a name of `facet list datasets`, or a folder or spec
  std::optional<std::filesystem::path> annotations;  ///< truth that wins over the data set's own
};

/// The experiment that scores stored predictions: one method of kind `predictions`, not timed.
Experiment score_experiment(const ScoreRequest& request);

/// Runs it like any other experiment. Frames without a prediction count as failed.
RunOutcome score_predictions(const ScoreRequest& request, const RunOptions& options, RunObserver& observer,
                             const std::atomic<int>& stop_signal);

}  // namespace facet
