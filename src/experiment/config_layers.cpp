#include "experiment/config_layers.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiment/yaml_reader.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;

enum class Content { experiment, parameters };

void merge_over(ConfigValue& base, ConfigValue top) {
  if (!base.is_map() || !top.is_map()) {
    base = std::move(top);
    return;
  }
  for (ConfigEntry& entry : top.entries) {
    ConfigEntry* below = base.find(entry.key);
    if (below != nullptr && below->value.is_map() && entry.value.is_map())
      merge_over(below->value, std::move(entry.value));
    else
      base.set(std::move(entry));
  }
}

/// Nested maps to dotted keys: {wiener: {window_px: 3}} and {wiener.window_px: 3} are the same parameter.
void flatten_into(ConfigValue& flat, ConfigValue& nested, const std::string& prefix, ConfigErrors& errors) {
  for (ConfigEntry& entry : nested.entries) {
    const std::string key = prefix + entry.key;
    if (entry.value.is_map() && !entry.value.entries.empty()) {
      flatten_into(flat, entry.value, key + '.', errors);
    } else if (const ConfigEntry* first = flat.find(key)) {
      errors.add(entry.key_origin,
                 fmt::format("duplicate key \"{}\", first given at {}", key, first->key_origin.text()));
    } else {
      flat.entries.push_back({key, entry.key_origin, std::move(entry.value)});
    }
  }
}

void flatten(ConfigValue& parameters, ConfigErrors& errors) {
  ConfigValue flat;
  flat.kind = ConfigValue::Kind::map;
  flat.origin = parameters.origin;
  flatten_into(flat, parameters, "", errors);
  parameters = std::move(flat);
}

class LayerLoader {
 public:
  explicit LayerLoader(ConfigErrors& errors) : errors_(errors) {}

  ConfigValue load(const fs::path& file, Content content) {
    open_.push_back(fs::weakly_canonical(file));
    ConfigValue document = read_yaml_file(file, errors_);
    if (document.is_map()) {
      check_schema(document);
      resolve(document, content, file.parent_path());
    } else {
      errors_.add(document.origin, "expected a map with `schema: 1`, got " + document.describe());
    }
    open_.pop_back();
    return document;
  }

 private:
  void check_schema(ConfigValue& document) {
    const ConfigEntry* schema = document.find("schema");
    if (schema == nullptr)
      errors_.add(document.origin, "schema: missing; the file must say `schema: 1`");
    else if (!schema->value.is_scalar() || schema->value.quoted || schema->value.scalar != "1")
      errors_.add(schema->value.origin, "schema", schema->value.describe(), "1, the one version there is");
    document.erase("schema");
  }

  /// Puts what `document` extends underneath it.
  void resolve(ConfigValue& document, Content content, const fs::path& directory) {
    ConfigValue base;
    base.kind = ConfigValue::Kind::map;
    for (const ConfigValue& name : take_extends(document))
      if (const fs::path file = base_file(name, directory); !file.empty())
        merge_over(base, load(file, content));
    if (content == Content::parameters)
      flatten(document, errors_);
    else
      resolve_methods(document, directory);
    base.origin = document.origin;
    merge_over(base, std::move(document));
    document = std::move(base);
  }

  void resolve_methods(ConfigValue& experiment, const fs::path& directory) {
    ConfigEntry* methods = experiment.find("methods");
    if (methods == nullptr) return;
    for (ConfigValue& method : methods->value.items)
      if (ConfigEntry* params = method.find("params"); params != nullptr && params->value.is_map())
        resolve(params->value, Content::parameters, directory);
  }

  std::vector<ConfigValue> take_extends(ConfigValue& document) {
    const ConfigEntry* found = document.find("extends");
    if (found == nullptr) return {};
    ConfigValue value = found->value;
    document.erase("extends");
    if (value.is_scalar()) return {value};
    if (value.is_list()) return value.items;
    errors_.add(value.origin, "extends", value.describe(), "a file name or a list of file names");
    return {};
  }

  /// The file a name stands for; empty, with an error added, where it cannot be used.
  fs::path base_file(const ConfigValue& name, const fs::path& directory) {
    if (!name.is_scalar()) {
      errors_.add(name.origin, "extends", name.describe(), "a file name");
      return {};
    }
    const fs::path file = directory / name.scalar;
    std::error_code failed;
    if (!fs::is_regular_file(file, failed)) {
      errors_.add(name.origin, "extends", name.scalar,
                  fmt::format("an existing file, {} is none", file.string()));
      return {};
    }
    if (std::find(open_.begin(), open_.end(), fs::weakly_canonical(file)) != open_.end()) {
      errors_.add(name.origin, "extends", name.scalar, "no cycle, but the file extends itself in the end");
      return {};
    }
    return file;
  }

  ConfigErrors& errors_;
  std::vector<fs::path> open_;  ///< the files being loaded, outermost first
};

}  // namespace

ConfigValue load_layers(const fs::path& file, ConfigErrors& errors) {
  return LayerLoader(errors).load(file, Content::experiment);
}

}  // namespace facet
