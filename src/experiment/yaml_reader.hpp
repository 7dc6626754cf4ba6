#pragma once

#include <filesystem>

#include "experiment/config_errors.hpp"
#include "experiment/config_value.hpp"

namespace facet {

/// Parses one YAML file into values that carry their marks. Duplicate keys, `<<`, anchors, aliases, explicit
/// tags, keys that are not scalars and a second document are added to `errors`: yaml-cpp 0.7 accepts or
/// ignores them. A file that cannot be read or is no YAML throws Error{config}.
ConfigValue read_yaml_file(const std::filesystem::path& file, ConfigErrors& errors);

/// The same for the text of one value, as after the `=` of --set.
ConfigValue read_yaml_text(const std::string& text, const std::string& source, ConfigErrors& errors);

}  // namespace facet
