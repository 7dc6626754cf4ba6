#pragma once

#include <filesystem>

#include "experiment/plan.hpp"
#include "experiment/run_observer.hpp"
#include "study/ablation_plan.hpp"

namespace facet {

/// A strip per ablation and frame from the predictions that a run has stored:
/// RUN/strips/DESIGN_BASE/DATASET/FRAME.png. Frames without a prediction of every variant get none.
void write_ablation_strips(const AblationPlan& ablation, const Plan& plan, const std::filesystem::path& run);

}  // namespace facet
