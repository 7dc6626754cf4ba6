#include "experiment/experiment_reader.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <set>

#include "experiment/config_layers.hpp"
#include "experiment/experiment_fields.hpp"
#include "experiment/stream_reader.hpp"
#include "score/metrics.hpp"
#include "study/switches.hpp"

namespace facet {
namespace {

ConfigEntry built_in_entry(const std::string& key, ConfigValue::Kind kind) {
  ConfigEntry entry;
  entry.key = key;
  entry.value.kind = kind;
  return entry;
}

ConfigEntry named_list(const std::string& key, const std::string& element_name) {
  ConfigEntry name = built_in_entry("name", ConfigValue::Kind::scalar);
  name.value.scalar = element_name;
  ConfigValue element;
  element.kind = ConfigValue::Kind::map;
  element.entries.push_back(std::move(name));
  ConfigEntry list = built_in_entry(key, ConfigValue::Kind::list);
  list.value.items.push_back(std::move(element));
  return list;
}

/// The built-in data set and method, so that --set can address them.
void add_built_in_lists(ConfigValue& tree) {
  const Experiment built_in = built_in_experiment();
  if (tree.find("datasets") == nullptr) tree.set(named_list("datasets", built_in.datasets.front().name));
  if (tree.find("methods") == nullptr) tree.set(named_list("methods", built_in.methods.front().name));
}

std::string element_path(const ConfigValue& element, const std::string& section, std::size_t index) {
  const ConfigEntry* name = element.find("name");
  if (name != nullptr && name->value.is_scalar()) return section + '.' + name->value.scalar;
  return element.is_scalar() ? section + '.' + element.scalar : fmt::format("{}[{}]", section, index);
}

template <class Spec, class Read>
std::vector<Spec> read_elements(SectionReader& reader, const std::string& section, ConfigErrors& errors,
                                const Read& read) {
  std::vector<Spec> specs;
  std::set<std::string> names;
  const auto items = reader.take_list(section, "a list with at least one entry");
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::string where = element_path(items[i], section, i);
    specs.push_back(read(items[i], where));
    if (!specs.back().name.empty() && !names.insert(specs.back().name).second)
      errors.add(items[i].origin, where, specs.back().name, "a name that is used once");
  }
  return specs;
}

/// A list of names that must be among `known`; empty where the key is absent.
std::vector<std::string> read_names(SectionReader& reader, const std::string& key, const std::string& what,
                                    const std::vector<std::string>& known) {
  const std::string expected = fmt::format("{} among {}", what, fmt::join(known, ", "));
  std::vector<std::string> names;
  for (const ConfigValue& item : reader.take_list(key, expected)) {
    if (std::find(known.begin(), known.end(), item.scalar) == known.end())
      reader.reject(item, key, expected, nearest_name(item.scalar, known));
    names.push_back(item.scalar);
  }
  return names;
}

template <class Table>
std::vector<std::string> names_in(const Table& table) {
  std::vector<std::string> names;
  for (const auto& row : table) names.emplace_back(row.name);
  return names;
}

AblationOptions read_ablation(const ConfigValue& value, const std::string& where, ConfigErrors& errors,
                              OriginTable& origins) {
  AblationOptions options;
  SectionReader reader(value, where, errors, origins);
  visit_ablation_fields(options, reader);
  options.switches = read_names(reader, "switches", "switches", names_in(ablation_switches()));
  const std::vector<std::string> metrics =
      read_names(reader, "metrics", "metrics", names_in(score_metrics()));
  if (!metrics.empty()) options.metrics = metrics;
  reader.finish();
  return options;
}

/// One design, or a list of them.
std::vector<AblationOptions> read_ablations(const ConfigValue& value, ConfigErrors& errors,
                                            OriginTable& origins) {
  if (!value.is_list()) return {read_ablation(value, "ablation", errors, origins)};
  std::vector<AblationOptions> ablations;
  for (std::size_t i = 0; i < value.items.size(); ++i)
    ablations.push_back(read_ablation(value.items[i], fmt::format("ablation[{}]", i), errors, origins));
  return ablations;
}

/// Checks a swept value by reading it as its parameter.
std::vector<SweepAxis> read_sweep(const ConfigValue& value, ConfigErrors& errors, OriginTable& origins) {
  std::vector<SweepAxis> axes;
  SectionReader section(value, "sweep", errors, origins);
  PipelineParams scratch;
  visit_fields(scratch, [&](std::string_view key, auto& member, const FieldInfo& info) {
    const ConfigValue* list = section.take(key);
    if (list == nullptr) return;
    SweepAxis axis{std::string(key), {}};
    if (!list->is_list() || list->items.empty()) section.reject(*list, key, "a list of values");
    for (const ConfigValue& item : list->items) {
      if (!read_typed(item, member) || !in_range(member, info))
        section.reject(item, key, expectation<std::decay_t<decltype(member)>>(info));
      axis.values.push_back(item.scalar);
    }
    axes.push_back(std::move(axis));
  });
  section.finish();
  return axes;
}

void read_name(SectionReader& reader, Experiment& experiment) {
  const ConfigValue* name = reader.take("name");
  if (name == nullptr) return;
  if (!read_typed(*name, experiment.name) || !is_plain_name(experiment.name))
    reader.reject(*name, "name", "letters, digits, '.', '_' and '-'");
}

void read_sections(SectionReader& reader, LoadedExperiment& loaded, ConfigErrors& errors) {
  Experiment& e = loaded.experiment;
  OriginTable& origins = loaded.origins;
  const auto section = [&](const char* key, auto&& visit_section, auto& options) {
    const ConfigValue* value = reader.take(key);
    if (value == nullptr) return;
    SectionReader inner(*value, key, errors, origins);
    visit_section(options, inner);
    inner.finish();
  };
  section(
      "score", [](auto& o, auto& v) { visit_score_fields(o, v); }, e.score);
  section(
      "timing", [](auto& o, auto& v) { visit_timing_fields(o, v); }, e.timing);
  section(
      "outputs", [](auto& o, auto& v) { visit_output_fields(o, v); }, e.outputs);
  if (const ConfigValue* ablation = reader.take("ablation"))
    e.ablations = read_ablations(*ablation, errors, origins);
  if (const ConfigValue* stream = reader.take("stream")) e.stream = read_stream(*stream, errors, origins);
  if (const ConfigValue* sweep = reader.take("sweep")) e.sweep = read_sweep(*sweep, errors, origins);
}

}  // namespace

bool is_plain_name(const std::string& name) {
  return !name.empty() && name.front() != '.' && std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return c < 128 && (std::isalnum(c) || c == '.' || c == '_' || c == '-');
  });
}

Experiment built_in_experiment() {
  Experiment experiment;
  experiment.datasets = {named_dataset("synthetic")};
  experiment.methods = {MethodSpec{}};
  return experiment;
}

LoadedExperiment load_experiment(const std::filesystem::path& file,
                                 const std::vector<std::string>& overrides) {
  ConfigErrors errors;
  ConfigValue tree = load_layers(file, errors);
  errors.throw_if_any();
  add_built_in_lists(tree);
  apply_overrides(tree, overrides, errors);
  LoadedExperiment loaded;
  Experiment& experiment = loaded.experiment;
  experiment.name = file.stem().string();
  SectionReader reader(tree, "", errors, loaded.origins);
  reader.take("schema");
  read_name(reader, experiment);
  visit_seed_field(experiment.seed, reader);
  experiment.datasets = read_elements<DatasetSpec>(
      reader, "datasets", errors,
      [&](const auto& item, const auto& where) { return read_dataset(item, where, errors, loaded.origins); });
  experiment.methods = read_elements<MethodSpec>(
      reader, "methods", errors,
      [&](const auto& item, const auto& where) { return read_method(item, where, errors, loaded.origins); });
  read_sections(reader, loaded, errors);
  reader.finish();
  errors.throw_if_any();
  return loaded;
}

}  // namespace facet
