#include "experiment/config_writer.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiment/experiment_fields.hpp"
#include "method/method_fields.hpp"
#include "method/registry.hpp"

namespace facet {
namespace {

/// Comment for a value: its path and, as text, what the schema expects and what it means.
using Annotate =
    std::function<std::string(const std::string& path, const std::string& expected, std::string_view doc)>;

std::string quote(const std::string& text) {
  if (is_plain_name(text) && text.find_first_not_of("0123456789.-+eE_") != text.npos && text != "null" &&
      text != "true" && text != "false" && text != "all")
    return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    if (c == '\n')
      quoted += "\\n";
    else
      quoted += c;
  }
  return quoted + '"';
}

class ConfigWriter {
 public:
  explicit ConfigWriter(Annotate annotate) : annotate_(std::move(annotate)) {}

  void line(int indent, const std::string& key, const std::string& value, const std::string& path,
            const std::string& expected = {}, std::string_view doc = {}) {
    const std::string text = fmt::format("{:{}}{}: {}", "", indent, key, value);
    const std::string comment = annotate_(path, expected, doc);
    text_ += comment.empty() ? text + '\n' : fmt::format("{:<48} # {}\n", text, comment);
  }
  void raw(const std::string& text) { text_ += text + '\n'; }
  /// A visitor for a section's field list.
  auto fields(int indent, const std::string& path) {
    return [this, indent, path](std::string_view key, const auto& value, const FieldInfo& info) {
      using T = std::decay_t<decltype(value)>;
      const std::string full = path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
      if constexpr (std::is_same_v<T, std::string>)
        line(indent, std::string(key), quote(value), full, expectation<T>(info), info.doc);
      else
        line(indent, std::string(key), spell(value), full, expectation<T>(info), info.doc);
    };
  }
  void dataset(const DatasetSpec& spec) {
    const std::string path = "datasets." + spec.name;
    line(2, "- name", spec.name, path + ".name", "text", "name of the data set in every output");
    line(4, "reader", spec.reader, path + ".reader", "a name of `facet list datasets`", "reads the files");
    if (!spec.root.empty())
      line(4, "root", quote(spec.root.string()), path + ".root", "a folder", "where it lies");
    if (!spec.annotations.empty())
      line(4, "annotations", quote(spec.annotations.string()), path + ".annotations", "a folder",
           "truth that wins over what the data set has");
    line(4, "sensor", spell(spec.sensor), path + ".sensor", expectation<Sensor>({}),
         "auto = as the reader declares");
    line(4, "frames", frames(spec), path + ".frames", "all, or a list of frame ids",
         "which frames, in order");
    if (!spec.kinds.empty()) line(4, "kinds", list_of(spec.kinds), path + ".kinds");
    for (const auto& [key, value] : spec.options) line(4, key, option(spec, key, value), path + '.' + key);
  }
  void method(const MethodSpec& spec) {
    const std::string path = "methods." + spec.name;
    line(2, "- name", spec.name, path + ".name", "text", "name of the method in every output");
    line(4, "kind", spec.kind, path + ".kind", "a name of `facet list methods`", "what runs");
    if (!spec.folder.empty())
      line(4, "folder", quote(spec.folder.string()), path + ".folder", "a folder",
           find_method_kind(spec).folder);
    raw("    params:");
    visit_method_fields(spec, fields(6, path + ".params"));
  }
  void stream(const StreamOptions& options) {
    raw("stream:");
    visit_stream_fields(options, fields(2, "stream"));
    raw("  filters:");
    for (const StreamFilter& filter : options.filters)
      raw(fmt::format("    - {{name: {}, until: {}, threads: {}}}", quote(filter.name), spell(filter.until),
                      filter.threads));
  }
  std::string take() { return std::move(text_); }

 private:
  static std::string frames(const DatasetSpec& spec) {
    return spec.frames.empty() ? "all" : list_of(spec.frames);
  }
  static std::string list_of(const std::vector<std::string>& texts) {
    std::string list;
    for (const std::string& text : texts) list += (list.empty() ? "[" : ", ") + quote(text);
    return list + ']';
  }
  /// Options are kept as text; the reader's table tells whether they were numbers, lists or text.
  static std::string option(const DatasetSpec& spec, const std::string& key, const std::string& value) {
    for (const OptionInfo& info : find_reader(spec.reader).options) {
      if (info.name != key) continue;
      if (info.type == OptionType::numbers) return '[' + value + ']';
      if (info.type == OptionType::text) return quote(value);
    }
    return value;
  }

  Annotate annotate_;
  std::string text_;
};

void write_studies(ConfigWriter& writer, const Experiment& e) {
  if (!e.ablations.empty()) writer.raw("ablation:");
  for (const AblationOptions& ablation : e.ablations) {
    const std::string design(enum_name(ablation.design));
    writer.raw(fmt::format("  - {{design: {}, base: {}, switches: [{}], metrics: [{}]}}", design,
                           ablation.base, fmt::join(ablation.switches, ", "),
                           fmt::join(ablation.metrics, ", ")));
  }
  if (!e.sweep.empty()) writer.raw("sweep:");
  for (const SweepAxis& axis : e.sweep)
    writer.line(2, axis.parameter, fmt::format("[{}]", fmt::join(axis.values, ", ")),
                "sweep." + axis.parameter);
}

std::string write(const Experiment& e, const std::string& head, Annotate annotate) {
  ConfigWriter writer(std::move(annotate));
  writer.raw(head + "schema: 1");
  if (!e.name.empty()) writer.line(0, "name", e.name, "name");
  visit_seed_field(e.seed, writer.fields(0, ""));
  writer.raw("datasets:");
  for (const DatasetSpec& spec : e.datasets) writer.dataset(spec);
  writer.raw("methods:");
  for (const MethodSpec& spec : e.methods) writer.method(spec);
  writer.raw("score:");
  visit_score_fields(e.score, writer.fields(2, "score"));
  writer.raw("timing:");
  visit_timing_fields(e.timing, writer.fields(2, "timing"));
  writer.raw("outputs:");
  visit_output_fields(e.outputs, writer.fields(2, "outputs"));
  writer.stream(e.stream);
  write_studies(writer, e);
  return writer.take();
}

}  // namespace

std::string write_config(const Experiment& experiment) {
  return write(experiment, "", [](const auto&, const auto&, auto) { return std::string(); });
}

std::string write_config_with_origins(const LoadedExperiment& loaded) {
  return write(loaded.experiment, "", [&](const std::string& path, const auto&, auto) {
    const auto found = loaded.origins.find(path);
    return found == loaded.origins.end() ? Origin{}.text() : found->second.text();
  });
}

std::string write_default_config() {
  const std::string head =
      "# Every key of an experiment with its default. Written by `facet show-config --defaults`; do not "
      "edit.\n"
      "# `name` is the name of the file unless it is given.\n";
  return write(built_in_experiment(), head,
               [](const auto&, const std::string& expected, std::string_view doc) {
                 return fmt::format("{}; {}", doc, expected);
               });
}

}  // namespace facet
