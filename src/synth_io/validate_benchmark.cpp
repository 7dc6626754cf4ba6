#include "synth_io/validate_benchmark.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <set>

#include "core/error.hpp"
#include "file/file_bytes.hpp"
#include "file/image_file.hpp"
#include "synth_io/benchmark_folder.hpp"
#include "synth_io/checksums.hpp"
#include "truth/annotation.hpp"

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

/// Groups of the annotation without a pixel in the mask.
std::set<int> groups_not_in(const Truth& truth, const cv::Mat& mask) {
  std::set<int> groups;
  for (const TruthSurface& surface : truth.surfaces) groups.insert(surface.object);
  for (const TruthEdge& edge : truth.edges) groups.insert(edge.object);
  for (int y = 0; y < mask.rows && !groups.empty(); ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      groups.erase(mask.depth() == CV_16U ? mask.at<std::uint16_t>(y, x) : mask.at<std::uint8_t>(y, x));
    }
  }
  return groups;
}

void validate_file(const fs::path& file, const fs::path& mask_file, ValidationReport& report) {
  const std::vector<std::uint8_t> bytes = read_file_bytes(file);
  const std::string text(bytes.begin(), bytes.end());
  cv::Mat mask;
  if (fs::exists(mask_file)) mask = read_image_file(mask_file).pixels;
  if (mask.channels() != 1 || mask.depth() > CV_16U || mask.depth() == CV_8S)
    throw Error(ErrorKind::data, printable(mask_file) + ": expected one channel of 8 or 16 bit integers");
  const Size size = mask.empty() ? declared_size(text) : Size{mask.cols, mask.rows};
  const Annotation annotation = parse_annotation(text, size);
  for (const AnnotationProblem& problem : annotation.problems) {
    report.problems.push_back(
        printable(file) + ": " +
        (problem.shape ? "shape " + std::to_string(*problem.shape) + ": " : std::string()) + problem.rule);
  }
  if (mask.empty()) return;
  for (const int group : groups_not_in(annotation.truth, mask)) {
    report.problems.push_back(printable(file) + ": group_id " + std::to_string(group) + " has no pixel in " +
                              printable(mask_file.filename()));
  }
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
