#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiment/config_errors.hpp"
#include "experiment/config_value.hpp"

namespace facet {

/// Reads an experiment file and everything it extends into one tree: maps merge key by key, anything else is
/// replaced, later over earlier. `extends` names one file or a list of them, relative to the file that says
/// so, and works inside a method's `params` too. Parameters come out flat, with dotted keys.
ConfigValue load_layers(const std::filesystem::path& file, ConfigErrors& errors);

/// Applies "a.b=value" options in order. A path that starts with a section of an experiment addresses it,
/// list elements by their name (methods.default.params.cd.high_deg); any other path is a parameter of every
/// method.
void apply_overrides(ConfigValue& experiment, const std::vector<std::string>& options, ConfigErrors& errors);

}  // namespace facet
