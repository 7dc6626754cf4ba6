#pragma once

#include <functional>
#include <string>

#include "experiment/experiment_reader.hpp"

namespace facet {

/// The experiment as YAML with every key, for config.resolved.yaml and for its hash.
std::string write_config(const Experiment& experiment);

/// The same with the origin of every value as a comment.
std::string write_config_with_origins(const LoadedExperiment& loaded);

/// configs/default.yaml: every key with its default, meaning, unit and range.
std::string write_default_config();

}  // namespace facet
