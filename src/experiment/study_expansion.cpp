#include "experiment/study_expansion.hpp"

#include "core/error.hpp"
#include "experiment/sweep_plan.hpp"

namespace facet {
namespace {

void check_sections(const Experiment& experiment, Study study) {
  const auto reject = [](const std::string& message) { throw Error(ErrorKind::config, message); };
  if (study == Study::ablation && experiment.ablations.empty())
    reject("no section `ablation`: nothing to ablate");
  if (study == Study::sweep && experiment.sweep.empty()) reject("no section `sweep`: nothing to sweep");
  if (study == Study::none && !experiment.ablations.empty()) reject("section `ablation` is for facet ablate");
  if (study == Study::none && !experiment.sweep.empty()) reject("section `sweep` is for facet sweep");
}

}  // namespace

Experiment expand_study(const Experiment& experiment, Study study) {
  check_sections(experiment, study);
  Experiment expanded = experiment;
  if (study == Study::ablation)
    expanded.methods = plan_ablations(experiment.ablations, experiment.methods).methods;
  if (study == Study::sweep) {
    expanded.methods.clear();
    for (const SweepPoint& point : plan_sweep(experiment)) expanded.methods.push_back(point.method);
  }
  return expanded;
}

std::string study_name(Study study) {
  return study == Study::ablation ? "ablation" : study == Study::sweep ? "sweep" : "";
}

Study study_named(const std::string& name) {
  return name == "ablation" ? Study::ablation : name == "sweep" ? Study::sweep : Study::none;
}

}  // namespace facet
