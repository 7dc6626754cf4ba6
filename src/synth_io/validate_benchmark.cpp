#include "synth_io/validate_benchmark.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "file/file_bytes.hpp"
#include "synth_io/benchmark_folder.hpp"
#include "synth_io/checksums.hpp"
#include "truth/annotation.hpp"
#include "truth/frame_annotation.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> annotations_below(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_regular_file() && name.ends_with(".json") && !name.ends_with(".geometry.json")) {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

Size declared_size(const std::string& text) {
  const auto root = nlohmann::json::parse(text, nullptr, false);
  if (!root.is_object()) return {};
  const auto number = [&](const char* key) {
    return root.contains(key) && root[key].is_number_integer() ? root[key].get<int>() : 0;
  };
  return {number("imageWidth"), number("imageHeight")};
}

void validate_file(const fs::path& file, const fs::path& mask_file, ValidationReport& report) {
  const std::vector<std::uint8_t> bytes = read_file_bytes(file);
  const std::string text(bytes.begin(), bytes.end());
  Image<std::uint16_t> masks;
  if (fs::exists(mask_file)) masks = read_object_masks(mask_file);
  const Size size = masks.empty() ? declared_size(text) : masks.size();
  const Annotation annotation = parse_annotation(text, size);
  for (const AnnotationProblem& problem : annotation.problems) {
    report.problems.push_back(
        printable(file) + ": " +
        (problem.shape ? "shape " + std::to_string(*problem.shape) + ": " : std::string()) + problem.rule);
  }
  if (masks.empty()) return;
  for (const std::string& problem : mask_problems(annotation.truth, masks))
    report.problems.push_back(printable(file) + ": " + problem);
}

}  // namespace

ValidationReport validate_annotations(const fs::path& folder, const fs::path& mask_folder) {
  if (!fs::is_directory(folder)) throw Error(ErrorKind::data, printable(folder) + ": folder is missing");
  require_finished(folder);
  ValidationReport report;
  for (const fs::path& file : annotations_below(folder)) {
    const fs::path beside = fs::path(file).replace_extension(".objects.png");
    const fs::path apart = mask_folder / file.filename().replace_extension(".png");
    ++report.frames;
    try {
      validate_file(file, mask_folder.empty() ? beside : apart, report);
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::data) throw;
      report.problems.push_back(error.what());  // a file that cannot be read; the others still can
    }
  }
  if (report.frames == 0)
    throw Error(ErrorKind::data, printable(folder) + ": no annotation (*.json) is here");
  return report;
}

ValidationReport validate_benchmark(const fs::path& folder) {
  ValidationReport report = validate_annotations(folder);
  const auto more = checksum_problems(folder);
  report.problems.insert(report.problems.end(), more.begin(), more.end());
  return report;
}

}  // namespace facet
