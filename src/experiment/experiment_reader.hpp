#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiment/experiment.hpp"
#include "experiment/section_reader.hpp"

namespace facet {

/// An experiment and where each of its values was written.
struct LoadedExperiment {
  Experiment experiment;
  OriginTable origins;
};

/// What runs when an experiment names no data set and no method: one synthetic data set, the default method.
Experiment built_in_experiment();

/// Reads an experiment file with what it extends and the `--set` options, built-in < base files < file <
/// options. Throws Error{config} with every error found, one per line: "file:line:col: path: value V:
/// expected E".
LoadedExperiment load_experiment(const std::filesystem::path& file,
                                 const std::vector<std::string>& overrides = {});

/// A data set by its name alone: the reader of that name, below the data root.
DatasetSpec named_dataset(const std::string& name);

/// Reads one entry of `datasets`; `where` names it in messages.
DatasetSpec read_dataset(const ConfigValue& value, const std::string& where, ConfigErrors& errors,
                         OriginTable& origins);

/// Reads one entry of `methods`.
MethodSpec read_method(const ConfigValue& value, const std::string& where, ConfigErrors& errors,
                       OriginTable& origins);

/// Letters, digits, '.', '_' and '-', not starting with '.': safe as the name of a folder.
bool is_plain_name(const std::string& name);

}  // namespace facet
