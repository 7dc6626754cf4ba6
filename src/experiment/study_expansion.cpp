#include "experiment/study_expansion.hpp"

#include "core/error.hpp"

namespace facet {
namespace {

void check_sections(const Experiment& experiment, Study study) {
  const auto reject = [](const std::string& message) { throw Error(ErrorKind::config, message); };
  if (study == Study::ablation && experiment.ablations.empty())
    reject("no section `ablation`: nothing to ablate");
  if (study == Study::sweep) reject("section `sweep` is not built in this version");
  if (study == Study::none && !experiment.ablations.empty()) reject("section `ablation` is for facet ablate");
  if (study == Study::none && !experiment.sweep.empty()) reject("section `sweep` is for facet sweep");
}

}  // namespace

Experiment expand_study(const Experiment& experiment, Study study) {
  check_sections(experiment, study);
  Experiment expanded = experiment;
  if (study == Study::ablation)
    expanded.methods = plan_ablations(experiment.ablations, experiment.methods).methods;
  return expanded;
}

}  // namespace facet
