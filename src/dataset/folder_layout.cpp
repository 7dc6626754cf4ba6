#include "dataset/folder_layout.hpp"

#include <algorithm>
#include <yaml-cpp/yaml.h>

#include "core/error.hpp"
#include "dataset/folder.hpp"
#include "dataset/intrinsics.hpp"
#include "file/file_bytes.hpp"

namespace facet {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, const YAML::Mark& mark, const std::string& rule) {
  throw Error(ErrorKind::config, printable(file) + ":" + std::to_string(mark.line + 1) + ":" +
                                     std::to_string(mark.column + 1) + ": " + rule);
}

/// The text of a scalar, or the texts of a list's items joined by commas.
std::string option_text(const YAML::Node& value, const std::string& name, const std::filesystem::path& file) {
  if (value.IsScalar()) return value.Scalar();
  if (!value.IsSequence()) fail(file, value.Mark(), name + ": expected a value or a list");
  std::string text;
  for (const auto& item : value) {
    if (!item.IsScalar()) fail(file, item.Mark(), name + ": expected a list of values");
    text += (text.empty() ? "" : ",") + item.Scalar();
  }
  return text;
}

void add_option(ReaderOptions& options, const YAML::Node& key, const YAML::Node& value,
                const std::filesystem::path& file) {
  if (!key.IsScalar()) fail(file, key.Mark(), "expected the name of an option");
  const std::string name = key.Scalar();
  if (options.contains(name)) fail(file, key.Mark(), "'" + name + "' stands twice");
  const ReaderOptions one{{name, option_text(value, name, file)}};
  try {
    check_options(one, folder_options(), "data set folder");
  } catch (const Error& e) {
    fail(file, key.Mark(), e.what());
  }
  options.insert(*one.begin());
}

std::string required_text(const ReaderOptions& options, std::string_view name,
                          const std::filesystem::path& root) {
  if (auto text = text_option(options, name)) return *text;
  throw Error(ErrorKind::config, printable(root) + ": option " + std::string(name) +
                                     " is required, in dataset.yaml or in the experiment");
}

Sensor parse_sensor(const std::string& text) {
  const auto found = std::find(sensor_names.begin(), sensor_names.end(), text);
  if (found != sensor_names.end()) return static_cast<Sensor>(found - sensor_names.begin());
  throw Error(ErrorKind::config,
              "option sensor: '" + text + "' is not known; auto, kinect_v1, azure_kinect, stereo are");
}

}  // namespace

ReaderOptions read_dataset_yaml(const std::filesystem::path& root) {
  const auto file = root / "dataset.yaml";
  ReaderOptions options;
  if (!std::filesystem::exists(file)) return options;
  const auto bytes = read_file_bytes(file);
  try {
    const YAML::Node top = YAML::Load(std::string(bytes.begin(), bytes.end()));
    if (!top.IsMap()) fail(file, top.Mark(), "expected a map of options");
    for (const auto& entry : top) add_option(options, entry.first, entry.second, file);
  } catch (const YAML::Exception& e) {
    fail(file, e.mark, e.msg);
  }
  return options;
}

FolderLayout folder_layout(const ReaderOptions& options, const std::filesystem::path& root) {
  FolderLayout layout{.depth = FramePattern(required_text(options, "depth", root))};
  required_text(options, "depth_unit_m", root);
  layout.format.unit_m = *number_option(options, "depth_unit_m");
  if (layout.format.unit_m <= 0)
    throw Error(ErrorKind::config,
                printable(root) + ": option depth_unit_m: expected a positive number of metres");
  const auto camera = intrinsics_option(options, root);
  if (!camera)
    throw Error(ErrorKind::config, printable(root) + ": option intrinsics or intrinsics_file is required");
  layout.camera = *camera;
  if (const auto pattern = text_option(options, "color")) layout.color.emplace(*pattern);
  layout.format.missing_codes = numbers_option(options, "missing_codes").value_or(std::vector<double>{});
  layout.registered = flag_option(options, "registered").value_or(layout.registered);
  layout.sequence = flag_option(options, "sequence").value_or(layout.sequence);
  layout.rate_hz = number_option(options, "rate_hz");
  if (layout.rate_hz && (!layout.sequence || *layout.rate_hz <= 0))
    throw Error(ErrorKind::config,
                printable(root) + ": option rate_hz: expected a positive number, with sequence: true");
  if (const auto sensor = text_option(options, "sensor")) layout.sensor = parse_sensor(*sensor);
  return layout;
}

}  // namespace facet
