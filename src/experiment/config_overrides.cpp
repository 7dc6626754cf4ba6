#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "core/error.hpp"
#include "experiment/config_layers.hpp"
#include "experiment/yaml_reader.hpp"

namespace facet {
namespace {

constexpr std::array<std::string_view, 11> experiment_keys{
    "name", "datasets", "methods", "score", "timing", "outputs", "ablation", "sweep", "stream", "seed", "schema"};

void stamp(ConfigValue& value, const Origin& origin) {
  value.origin = origin;
  for (ConfigValue& item : value.items) stamp(item, origin);
  for (ConfigEntry& entry : value.entries) {
    entry.key_origin = origin;
    stamp(entry.value, origin);
  }
}

struct Override {
  std::string path;
  ConfigValue value;
  Origin origin;
};

Override parse_override(const std::string& option, ConfigErrors& errors) {
  const std::size_t equals = option.find('=');
  if (equals == std::string::npos || equals == 0)
    throw Error(ErrorKind::usage, fmt::format("--set {}: expected KEY=VALUE", option));
  Override result{option.substr(0, equals), {}, {"--set " + option, 0, 0}};
  result.value = read_yaml_text(option.substr(equals + 1), result.origin.source, errors);
  stamp(result.value, result.origin);
  return result;
}

ConfigValue& child_map(ConfigValue& map, const std::string& key, const Origin& origin) {
  if (ConfigEntry* found = map.find(key); found != nullptr && found->value.is_map()) return found->value;
  ConfigValue empty;
  empty.kind = ConfigValue::Kind::map;
  empty.origin = origin;
  map.set({key, origin, empty});
  return map.find(key)->value;
}

std::pair<std::string, std::string> split_first(const std::string& path) {
  const std::size_t dot = path.find('.');
  return {path.substr(0, dot), dot == std::string::npos ? "" : path.substr(dot + 1)};
}

void set_in_map(ConfigValue& map, const std::string& path, const Override& change) {
  const auto [key, rest] = split_first(path);
  if (rest.empty())
    map.set({key, change.origin, change.value});
  else
    set_in_map(child_map(map, key, change.origin), rest, change);
}

/// Parameters and sweep axes have dotted keys of their own.
void set_dotted(ConfigValue& map, const std::string& key, const Override& change) {
  map.set({key, change.origin, change.value});
}

void set_in_method(ConfigValue& method, const std::string& path, const Override& change) {
  const auto [key, rest] = split_first(path);
  if (key == "params" && !rest.empty())
    set_dotted(child_map(method, key, change.origin), rest, change);
  else
    set_in_map(method, path, change);
}

std::string name_of(const ConfigValue& element) {
  if (element.is_scalar()) return element.scalar;
  const ConfigEntry* name = element.find("name");
  return name != nullptr ? name->value.scalar : "";
}

/// A data set given by its name alone becomes a map, so that it can carry a changed key.
void become_map(ConfigValue& element) {
  if (element.is_map()) return;
  ConfigValue map;
  map.kind = ConfigValue::Kind::map;
  map.origin = element.origin;
  map.entries.push_back({"name", element.origin, element});
  element = std::move(map);
}

void set_in_list(ConfigValue& list, const std::string& section, const std::string& path,
                 const Override& change, ConfigErrors& errors) {
  const auto [name, rest] = split_first(path);
  std::vector<std::string> names;
  for (ConfigValue& element : list.items) {
    names.push_back(name_of(element));
    if (names.back() != name || rest.empty()) continue;
    become_map(element);
    if (section == "methods")
      set_in_method(element, rest, change);
    else
      set_in_map(element, rest, change);
    return;
  }
  if (rest.empty())
    errors.add(change.origin, change.path, change.value.describe(), "a path to a key of the element");
  else
    errors.add(change.origin, change.path, change.value.describe(),
               fmt::format("the name of one of the {}", section), nearest_name(name, names));
}

/// A parameter by itself is one of the pipeline; others are named with their method.
bool is_pipeline(const ConfigValue& method) {
  const ConfigEntry* kind = method.find("kind");
  return kind == nullptr || kind->value.scalar == "pipeline";
}

void apply(ConfigValue& experiment, const Override& change, ConfigErrors& errors) {
  const auto [section, rest] = split_first(change.path);
  const bool in_experiment =
      std::find(experiment_keys.begin(), experiment_keys.end(), section) != experiment_keys.end();
  if (!in_experiment) {
    for (ConfigValue& method : experiment.find("methods")->value.items)
      if (method.is_map() && is_pipeline(method))
        set_dotted(child_map(method, "params", change.origin), change.path, change);
  } else if ((section == "methods" || section == "datasets") && !rest.empty()) {
    set_in_list(experiment.find(section)->value, section, rest, change, errors);
  } else if (section == "sweep" && !rest.empty()) {
    set_dotted(child_map(experiment, section, change.origin), rest, change);
  } else {
    set_in_map(experiment, change.path, change);
  }
}

}  // namespace

void apply_overrides(ConfigValue& experiment, const std::vector<std::string>& options, ConfigErrors& errors) {
  for (const std::string& option : options) apply(experiment, parse_override(option, errors), errors);
}

}  // namespace facet
