#pragma once

#include "experiment/experiment.hpp"
#include "experiment/run_options.hpp"

namespace facet {

/// "", "ablation" or "sweep", as manifests spell it.
std::string study_name(Study study);
Study study_named(const std::string& name);

/// The experiment with the methods that a study of it runs in place of its own. Throws Error{config} where
/// the file has no section for the study, or has one that this command does not run.
Experiment expand_study(const Experiment& experiment, Study study);

}  // namespace facet
