#include "truth/frame_annotation.hpp"

#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <set>

#include "core/error.hpp"
#include "file/file_bytes.hpp"
#include "file/image_file.hpp"
#include "truth/annotation.hpp"
#include "truth/truth_map.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;

Vec3 vector_from(const nlohmann::json& json) {
  return {json.at(0).get<float>(), json.at(1).get<float>(), json.at(2).get<float>()};
}

std::vector<TruePose> read_poses(const fs::path& file) {
  const auto bytes = read_file_bytes(file);
  std::vector<TruePose> poses;
  try {
    const auto geometry = nlohmann::json::parse(bytes.begin(), bytes.end());
    for (const auto& json : geometry.at("surfaces")) {
      TruePose pose{json.at("surface").get<int>(), std::nullopt, vector_from(json.at("centroid_m"))};
      if (const auto& plane = json.at("plane"); !plane.is_null())
        pose.plane = Plane{vector_from(plane.at("normal")), plane.at("d_m").get<float>()};
      poses.push_back(pose);
    }
  } catch (const nlohmann::json::exception& e) {
    throw Error(ErrorKind::data, fmt::format("{}: expected surfaces with surface, plane and centroid_m: {}",
                                             printable(file), e.what()));
  }
  return poses;
}

/// How many pixels of each mask the polygons of every surface cover.
std::vector<std::map<int, int>> mask_pixels(const Truth& truth, const Image<std::uint16_t>& object_masks) {
  const Image<std::uint16_t> drawn = rasterise(truth, {}, {}).drawn;
  std::vector<std::map<int, int>> pixels(truth.surfaces.size());
  for (int y = 0; y < drawn.height(); ++y)
    for (int x = 0; x < drawn.width(); ++x)
      if (drawn(x, y) > 0 && object_masks(x, y) > 0)
        ++pixels[drawn(x, y) - std::size_t{1}][object_masks(x, y)];
  return pixels;
}

std::set<int> values_of(const Image<std::uint16_t>& object_masks) {
  std::set<int> values;
  for (int y = 0; y < object_masks.height(); ++y)
    values.insert(object_masks.row(y), object_masks.row(y) + object_masks.width());
  return values;
}

void check_masks(const fs::path& file, const Truth& truth, const Image<std::uint16_t>& object_masks) {
  if (object_masks.empty()) return;
  std::string text;
  for (const std::string& problem : mask_problems(truth, object_masks))
    text += fmt::format("{}{}: {}", text.empty() ? "" : "\n", printable(file), problem);
  if (!text.empty()) throw Error(ErrorKind::data, text);
}

}  // namespace

Image<std::uint16_t> read_object_masks(const fs::path& path) {
  const cv::Mat pixels = read_image_file(path).pixels;
  if (pixels.channels() != 1 || (pixels.depth() != CV_8U && pixels.depth() != CV_16U))
    throw Error(ErrorKind::data, printable(path) + ": expected one channel of 8- or 16-bit integers");
  Image<std::uint16_t> masks(Size{pixels.cols, pixels.rows});
  for (int y = 0; y < pixels.rows; ++y)
    for (int x = 0; x < pixels.cols; ++x)
      masks(x, y) = pixels.depth() == CV_8U ? pixels.at<std::uint8_t>(y, x) : pixels.at<std::uint16_t>(y, x);
  return masks;
}

std::vector<std::string> mask_problems(const Truth& truth, const Image<std::uint16_t>& object_masks) {
  if (object_masks.size() != truth.size)
    return {fmt::format("the object masks have {} x {} px, the frame {} x {}", object_masks.width(),
                        object_masks.height(), truth.size.width, truth.size.height)};
  std::vector<std::string> problems;
  const auto pixels = mask_pixels(truth, object_masks);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    int best = 0, most = 0;
    for (const auto& [value, count] : pixels[i])
      if (count > most) best = value, most = count;
    if (most > 0 && best != truth.surfaces[i].object)
      problems.push_back(fmt::format("surface/{}: group_id {}, but most of it lies on object mask {}",
                                     truth.surfaces[i].number, truth.surfaces[i].object, best));
  }
  const std::set<int> values = values_of(object_masks);
  std::set<int> unknown;
  for (const TruthSurface& surface : truth.surfaces)
    if (!values.contains(surface.object)) unknown.insert(surface.object);
  for (const TruthEdge& edge : truth.edges)
    if (!values.contains(edge.object)) unknown.insert(edge.object);
  for (const int group : unknown)
    problems.push_back(fmt::format("group_id {} has no pixel in the object masks", group));
  return problems;
}

std::optional<FrameAnnotation> read_frame_annotation(const fs::path& folder, const std::string& id, Size size,
                                                     const Image<std::uint16_t>& given_masks) {
  const fs::path text = folder / (id + ".json"), masks = folder / (id + ".objects.png"),
                 geometry = folder / (id + ".geometry.json");
  FrameAnnotation annotation;
  annotation.object_masks = given_masks;
  if (fs::exists(masks)) {
    annotation.object_masks = read_object_masks(masks);
    annotation.files.push_back(masks);
    if (annotation.object_masks.size() != size)
      throw Error(ErrorKind::data, fmt::format("{}: {} x {} px, but the frame has {} x {}", printable(masks),
                                               annotation.object_masks.width(),
                                               annotation.object_masks.height(), size.width, size.height));
  }
  if (fs::exists(text)) {
    annotation.truth = read_annotation(text, size);
    annotation.files.push_back(text);
    check_masks(text, *annotation.truth, annotation.object_masks);
    if (fs::exists(geometry)) {
      annotation.poses = read_poses(geometry);
      annotation.files.push_back(geometry);
    }
  }
  if (annotation.files.empty()) return std::nullopt;
  annotation.source = printable(folder.lexically_normal());
  return annotation;
}

}  // namespace facet
