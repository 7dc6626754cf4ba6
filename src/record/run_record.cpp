#include "record/run_record.hpp"

#include <nlohmann/json.hpp>
#include <string_view>
#include <tbb/parallel_for.h>

#include "core/error.hpp"
#include "file/file_bytes.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string read_text(const fs::path& file) {
  const auto bytes = read_file_bytes(file);
  return {bytes.begin(), bytes.end()};
}

/// Empty where the run did not come so far as to write the file.
std::string read_text_if_any(const fs::path& file) {
  return fs::exists(file) && fs::file_size(file) > 0 ? read_text(file) : std::string();
}

/// Parsed from the bytes as they were read: of long runs there is no room for a second copy.
std::vector<FrameRow> read_rows(const fs::path& file) {
  if (!fs::exists(file) || fs::file_size(file) == 0) return {};
  const auto bytes = read_file_bytes(file);
  return frame_rows_from_jsonl({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

Calibration calibration_from_json(const Json& json) {
  return {json.at("repeats").get<int>(), json.at("median_ms").get<double>(), json.at("min_ms").get<double>()};
}

void flatten(const Json& json, const std::string& prefix,
             std::vector<std::pair<std::string, std::string>>& out) {
  for (const auto& [key, value] : json.items()) {
    const std::string name = prefix.empty() ? key : prefix + '.' + key;
    if (value.is_object())
      flatten(value, name, out);
    else
      out.emplace_back(name, value.is_string() ? value.get<std::string>() : value.dump());
  }
}

}  // namespace

std::vector<FrameRow> frame_rows_from_jsonl(std::string_view text) {
  std::vector<std::string_view> lines;
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
    lines.push_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  std::vector<FrameRow> rows(lines.size());
  tbb::parallel_for(std::size_t{0}, lines.size(),
                    [&](std::size_t i) { rows[i] = frame_row_from_json(lines[i]); });
  return rows;
}

RunRecord read_run(const fs::path& directory) {
  if (!fs::is_regular_file(directory / "manifest.json"))
    throw Error(ErrorKind::data, printable(directory) + ": not a run directory, it has no manifest.json");
  RunRecord run;
  run.manifest = manifest_from_json(read_text(directory / "manifest.json"));
  run.frames = read_rows(directory / "frames.jsonl");
  if (const std::string text = read_text_if_any(directory / "metrics/summary.json"); !text.empty())
    run.scores = score_results_from_json(text);
  if (const std::string text = read_text_if_any(directory / "gallery/gallery.json"); !text.empty())
    run.gallery = gallery_from_json(text);
  if (const std::string text = read_text_if_any(directory / "gallery/disputed.json"); !text.empty())
    run.disputed = gallery_from_json(text);
  for (const char* file : {"metrics/ablation.json", "timing/ablation.json"})
    if (const std::string text = read_text_if_any(directory / file); !text.empty())
      for (AblationRow& row : ablation_from_json(text)) run.ablation.push_back(std::move(row));
  for (const char* file : {"metrics/sweep.json", "timing/sweep.json"})
    if (const std::string text = read_text_if_any(directory / file); !text.empty())
      for (SweepRow& row : sweep_from_json(text)) run.sweep.push_back(std::move(row));
  run.timing = timing_from_csv(read_text_if_any(directory / "timing/samples.csv"));
  run.io_times = io_times_from_csv(read_text_if_any(directory / "timing/io.csv"));
  try {
    if (const std::string text = read_text_if_any(directory / "timing/calibration.json"); !text.empty())
      run.calibration = calibration_from_json(Json::parse(text));
    if (const std::string text = read_text_if_any(directory / "env.json"); !text.empty())
      flatten(Json::parse(text), "", run.environment);
  } catch (const nlohmann::json::exception& e) {
    throw Error(ErrorKind::data, printable(directory) + ": damaged JSON: " + e.what());
  }
  return run;
}

std::string to_json(const Calibration& calibration) {
  Json json;
  json["operations"] =
      "OpenCV GaussianBlur 5x5, Sobel 3x3 and medianBlur 5 on a fixed 640x480 float image, 1 thread";
  json["repeats"] = calibration.repeats;
  json["median_ms"] = calibration.median_ms;
  json["min_ms"] = calibration.min_ms;
  return json.dump(2) + '\n';
}

}  // namespace facet
