#include "synth_io/benchmark_spec.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/error.hpp"
#include "file/file_bytes.hpp"
#include "synth/frame_plan.hpp"
#include "synth_io/spec_reader.hpp"

namespace facet {
namespace {

void read_sensor(MapReader& reader, SensorSettings& sensor) {
  static const std::vector<std::string> models{"kinect_v1", "azure_kinect", "stereo"};
  static const std::vector<std::string> noises{"none", "khoshelham", "nguyen", "measured"};
  reader.choice("model", models, [&](std::size_t k) {
    sensor.model = k == 0 ? Sensor::kinect_v1 : k == 1 ? Sensor::azure_kinect : Sensor::stereo;
  });
  KinectV1& kinect = sensor.kinect_v1;
  AzureKinect& azure = sensor.azure_kinect;
  StereoCamera& stereo = sensor.stereo;
  reader.flag("exact", [&](bool on) { sensor.exact = on; });
  reader.number("scale", 0, 100,
                [&](double v) { kinect.scale = azure.scale = stereo.scale = static_cast<float>(v); });
  reader.flag("quantisation",
              [&](bool on) { kinect.quantisation = azure.quantisation = stereo.quantisation = on; });
  switch (sensor.model) {
    case Sensor::azure_kinect:
      reader.number("reflectivity", 0.05, 1, [&](double v) { azure.reflectivity = static_cast<float>(v); });
      reader.flag("random_error", [&](bool on) { azure.random_error = on; });
      reader.flag("systematic_error", [&](bool on) { azure.systematic_error = on; });
      reader.flag("flying_pixels", [&](bool on) { azure.flying_pixels = on; });
      reader.flag("multipath", [&](bool on) { azure.multipath = on; });
      reader.flag("mask", [&](bool on) { azure.mask = on; });
      break;
    case Sensor::stereo:
      reader.number("sigma_px", 0, 1, [&](double v) { stereo.sigma_px = static_cast<float>(v); });
      reader.flag("disparity_noise", [&](bool on) { stereo.disparity_noise = on; });
      reader.flag("fattening", [&](bool on) { stereo.fattening = on; });
      reader.flag("occlusion", [&](bool on) { stereo.occlusion = on; });
      reader.flag("smoothing", [&](bool on) { stereo.smoothing = on; });
      break;
    default:
      reader.choice("axial_noise", noises,
                    [&](std::size_t k) { kinect.axial_noise = static_cast<AxialNoise>(k); });
      reader.number("dropout", 0, 1, [&](double v) { kinect.dropout_share = static_cast<float>(v); });
      reader.flag("lateral_noise", [&](bool on) { kinect.lateral_noise = on; });
      reader.flag("shadow", [&](bool on) { kinect.shadow = on; });
      reader.flag("window_matching", [&](bool on) { kinect.window_matching = on; });
      reader.flag("dropouts", [&](bool on) { kinect.dropouts = on; });
      reader.flag("registration_border", [&](bool on) { kinect.registration_border = on; });
  }
}

void read_vary(MapReader& reader, SetSpec& set) {
  std::size_t kind = 0;
  for (const VaryInfo& info : vary_infos()) {
    const auto vary = static_cast<Vary>(++kind);
    reader.numbers(info.name, info.lowest, info.highest, [&](const std::vector<double>& levels) {
      if (set.vary != Vary::nothing) reader.problem(info.name, "a set varies one thing only");
      if (info.whole &&
          std::any_of(levels.begin(), levels.end(), [](double v) { return v != std::floor(v); }))
        reader.problem(info.name, "expected whole numbers");
      set.vary = vary;
      set.levels = levels;
    });
  }
}

void read_set(MapReader& reader, std::uint64_t seed, SetSpec& set) {
  set.seed = seed;
  for (const char* key : {"name", "scenes"}) reader.required(key);
  reader.text("name", [&](const std::string& text) {
    const bool plain = std::all_of(text.begin(), text.end(), [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
    });
    if (!plain) return reader.problem("name", "use lower case letters, digits and _ only");
    set.name = text;
  });
  reader.text("scenes", [&](const std::string& text) { set.scenes = text; });
  reader.integer("count", 1, 100000, [&](long long v) { set.count = static_cast<int>(v); });
  reader.integer("seed", 0, 9e15, [&](long long v) { set.seed = static_cast<std::uint64_t>(v); });
  reader.integer("frames", 1, 100000, [&](long long v) { set.frames = static_cast<int>(v); });
  reader.number("distance_m", 0.3, 10, [&](double v) { set.distance_m = v; });
  reader.map("sensor", [&](MapReader& inner) { read_sensor(inner, set.sensor); });
  reader.map("vary", [&](MapReader& inner) { read_vary(inner, set); });
  reader.map("path", [&](MapReader& inner) {
    inner.number("yaw_deg", -180, 180, [&](double v) { set.path_yaw_deg = v; });
    inner.number("distance_m", -2, 5, [&](double v) { set.path_distance_m = v; });
  });
  if (set.name.empty()) return;
  try {
    plan_frames(set);
  } catch (const Error& error) {
    reader.problem("scenes", error.what());
  }
}

/// A valid spec with another value of the key `seed`, put in where there is none; comments stay.
std::string text_with_seed(const std::string& text, std::uint64_t seed) {
  const YAML::Node root = YAML::Load(text);
  const YAML::Node old = root["seed"];
  const std::string value = std::to_string(seed);
  // Every spec has a schema, written as a number: the place before it takes a key in either style of map.
  for (const auto& entry : root) {
    if (entry.first.Scalar() != (old ? "seed" : "schema")) continue;
    const YAML::Mark place = old ? entry.second.Mark() : entry.first.Mark();
    std::size_t at = 0;
    for (int line = 0; line < place.line; ++line) at = text.find('\n', at) + 1;
    at += static_cast<std::size_t>(place.column);
    if (old) return std::string(text).replace(at, text.find_first_of(" \t\r\n,}#", at) - at, value);
    const bool flow = root.Style() == YAML::EmitterStyle::Flow;
    const std::string indent(static_cast<std::size_t>(place.column), ' ');
    return std::string(text).insert(at, "seed: " + value + (flow ? ", " : "\n" + indent));
  }
  return text;
}

}  // namespace

BenchmarkSpec parse_benchmark_spec(const std::string& text, const std::filesystem::path& name) {
  BenchmarkSpec spec{.name = {}, .sets = {}, .text = text};
  SpecProblems problems(name);
  YAML::Node root;
  try {
    root = YAML::Load(text);
  } catch (const YAML::ParserException& error) {
    throw Error(ErrorKind::config, printable(name) + ":" + std::to_string(error.mark.line + 1) + ":" +
                                       std::to_string(error.mark.column + 1) + ": " + error.msg);
  }
  MapReader reader(root, "", problems);
  std::uint64_t seed = 1;
  for (const char* key : {"schema", "name", "sets"}) reader.required(key);
  reader.integer("schema", 1, 1, [](long long) {});
  reader.text("name", [&](const std::string& value) { spec.name = value; });
  reader.integer("seed", 0, 9e15, [&](long long v) { seed = static_cast<std::uint64_t>(v); });
  std::set<std::string> names;
  reader.maps("sets", [&](MapReader& inner) {
    SetSpec set;
    read_set(inner, seed, set);
    if (!set.name.empty() && !names.insert(set.name).second)
      inner.problem("name", "two sets are called '" + set.name + "'");
    spec.sets.push_back(std::move(set));
  });
  reader.finish();
  problems.throw_if_any();
  return spec;
}

BenchmarkSpec read_benchmark_spec(const std::filesystem::path& file, std::optional<std::uint64_t> seed) {
  std::vector<std::uint8_t> bytes;
  try {
    bytes = read_file_bytes(file);
  } catch (const Error& error) {
    throw Error(ErrorKind::config, error.what());
  }
  BenchmarkSpec spec = parse_benchmark_spec({bytes.begin(), bytes.end()}, file);
  return seed ? parse_benchmark_spec(text_with_seed(spec.text, *seed), file) : spec;
}

}  // namespace facet
