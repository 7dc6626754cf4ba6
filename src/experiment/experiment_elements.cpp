#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "experiment/experiment_reader.hpp"
#include "method/method_fields.hpp"
#include "method/registry.hpp"

namespace facet {
namespace {

template <class Table>
std::vector<std::string> names_of(const Table& table) {
  std::vector<std::string> names;
  for (const auto& row : table) names.emplace_back(row.name);
  return names;
}

const ReaderInfo* reader_named(const std::string& name) {
  for (const ReaderInfo& info : readers())
    if (info.name == name) return &info;
  return nullptr;
}

void read_required_name(SectionReader& reader, const ConfigValue& section, std::string& name) {
  const ConfigValue* value = reader.take("name");
  if (value == nullptr)
    reader.reject(section, "name", "a name of its own");
  else if (!read_typed(*value, name) || !is_plain_name(name))
    reader.reject(*value, "name", "letters, digits, '.', '_' and '-'");
}

/// A root is relative to the file that names it; `${data_root}` is put in when the data is opened.
std::filesystem::path resolve_root(const ConfigValue& value) {
  if (value.scalar.starts_with("${")) return value.scalar;
  const std::filesystem::path root(value.scalar);
  const bool in_file = value.origin.line > 0;
  return root.is_absolute() || !in_file ? root
                                        : std::filesystem::path(value.origin.source).parent_path() / root;
}

void read_frames(SectionReader& reader, DatasetSpec& spec) {
  const std::string expected = "all, or a list of frame ids";
  const ConfigValue* value = reader.take("frames");
  if (value == nullptr || (value->is_scalar() && value->scalar == "all")) return;
  if (!value->is_list() || value->items.empty()) return reader.reject(*value, "frames", expected);
  for (const ConfigValue& item : value->items)
    if (std::string id; read_typed(item, id))
      spec.frames.push_back(id);
    else
      reader.reject(item, "frames", expected);
}

void read_kinds(SectionReader& reader, DatasetSpec& spec) {
  const std::string expected = "a list with what each of `frames` shows";
  const ConfigValue* value = reader.take("kinds");
  if (value == nullptr) return;
  if (!value->is_list() || value->items.size() != spec.frames.size())
    return reader.reject(*value, "kinds", expected);
  for (const ConfigValue& item : value->items)
    if (std::string kind; read_typed(item, kind))
      spec.kinds.push_back(kind);
    else
      reader.reject(item, "kinds", expected);
}

std::string join_scalars(const ConfigValue& value) {
  std::string text;
  for (const ConfigValue& item : value.items) text += (text.empty() ? "" : ",") + item.scalar;
  return text;
}

bool has_type(const ConfigValue& value, OptionType type) {
  double number = 0;
  bool flag = false;
  std::string text;
  switch (type) {
    case OptionType::number:
      return read_typed(value, number);
    case OptionType::flag:
      return read_typed(value, flag);
    case OptionType::text:
      return read_typed(value, text);
    default:
      return value.is_list() && !value.items.empty() &&
             std::all_of(value.items.begin(), value.items.end(), [](const ConfigValue& item) {
               double n = 0;
               return read_typed(item, n);
             });
  }
}

std::string option_expectation(OptionType type) {
  switch (type) {
    case OptionType::number:
      return "a number";
    case OptionType::flag:
      return "true or false";
    case OptionType::text:
      return "text";
    default:
      return "a list of numbers";
  }
}

void read_reader_options(SectionReader& reader, const ReaderInfo& info, DatasetSpec& spec) {
  for (const OptionInfo& option : info.options) {
    if (option.name == "sensor") continue;  // a key of every data set, read already
    const ConfigValue* value = reader.take(option.name);
    if (value == nullptr) continue;
    if (has_type(*value, option.type))
      spec.options[std::string(option.name)] = value->is_list() ? join_scalars(*value) : value->scalar;
    else
      reader.reject(*value, option.name, option_expectation(option.type));
  }
}

/// A program without a folder of its own runs beside the file that names it.
void read_method_folder(SectionReader& reader, const ConfigValue& method, MethodSpec& spec) {
  if (const ConfigValue* folder = reader.take("folder")) {
    spec.folder = resolve_root(*folder);
    if (spec.kind != "predictions" && spec.kind != "external")
      reader.reject(*folder, "folder", "nothing: only kinds predictions and external have a folder");
  } else if (spec.kind == "predictions") {
    reader.reject(method, "folder", "a folder of predictions");
  } else if (spec.kind == "external" && method.origin.line > 0) {
    spec.folder = std::filesystem::path(method.origin.source).parent_path() / ".";
  }
}

}  // namespace

DatasetSpec named_dataset(const std::string& name) {
  DatasetSpec spec;
  spec.name = spec.reader = name;
  const ReaderInfo* info = reader_named(name);
  if (info != nullptr && info->needs_root) spec.root = "${data_root}/" + name;
  return spec;
}

DatasetSpec read_dataset(const ConfigValue& value, const std::string& where, ConfigErrors& errors,
                         OriginTable& origins) {
  const std::vector<std::string> known = names_of(readers());
  const std::string expected = fmt::format("one of the readers {}", fmt::join(known, ", "));
  if (value.is_scalar()) {
    if (reader_named(value.scalar) == nullptr)
      errors.add(value.origin, where, value.describe(), expected, nearest_name(value.scalar, known));
    origins[where + ".name"] = value.origin;
    return named_dataset(value.scalar);
  }
  SectionReader reader(value, where, errors, origins);
  DatasetSpec spec;
  read_required_name(reader, value, spec.name);
  spec.reader = spec.name;
  if (const ConfigValue* kind = reader.take("reader")) spec.reader = kind->scalar;
  const ReaderInfo* info = reader_named(spec.reader);
  if (info == nullptr) {
    const ConfigEntry* named = value.find("reader");
    reader.reject(named != nullptr ? named->value : value, "reader", expected,
                  nearest_name(spec.reader, known));
    return spec;
  }
  if (info->needs_root) spec.root = "${data_root}/" + spec.name;
  if (const ConfigValue* root = reader.take("root")) spec.root = resolve_root(*root);
  if (const ConfigValue* folder = reader.take("annotations")) spec.annotations = resolve_root(*folder);
  reader("sensor", spec.sensor, FieldInfo{"", 0, 0, ""});
  read_frames(reader, spec);
  read_kinds(reader, spec);
  read_reader_options(reader, *info, spec);
  reader.finish();
  return spec;
}

MethodSpec read_method(const ConfigValue& value, const std::string& where, ConfigErrors& errors,
                       OriginTable& origins) {
  SectionReader reader(value, where, errors, origins);
  MethodSpec spec;
  spec.name.clear();
  if (!value.is_map()) return spec;
  read_required_name(reader, value, spec.name);
  const std::vector<std::string> known = names_of(method_kinds());
  if (const ConfigValue* kind = reader.take("kind")) {
    spec.kind = kind->scalar;
    if (std::find(known.begin(), known.end(), spec.kind) == known.end())
      reader.reject(*kind, "kind", fmt::format("one of {}", fmt::join(known, ", ")),
                    nearest_name(spec.kind, known));
  }
  read_method_folder(reader, value, spec);
  if (const ConfigValue* params = reader.take("params")) {
    SectionReader fields(*params, where + ".params", errors, origins);
    visit_method_fields(spec, fields);
    fields.finish();
    try {
      validate(spec.params);
    } catch (const Error& e) {
      errors.add(params->origin, where + ".params." + e.what());
    }
  }
  reader.finish();
  return spec;
}

}  // namespace facet
