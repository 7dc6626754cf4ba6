#include "synth_io/frame_files.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>

#include "core/error.hpp"
#include "file/file_bytes.hpp"
#include "file/image_file.hpp"
#include "synth_io/scene_annotation.hpp"
#include "truth/annotation.hpp"

namespace facet {
namespace {

cv::Mat depth_pixels(const Image<float>& depth_m) {
  cv::Mat out(depth_m.height(), depth_m.width(), CV_16U);
  for (int y = 0; y < out.rows; ++y) {
    for (int x = 0; x < out.cols; ++x) {
      out.at<std::uint16_t>(y, x) =
          cv::saturate_cast<std::uint16_t>(std::lround(depth_m(x, y) / depth_unit_m));
    }
  }
  return out;
}

cv::Mat colour_pixels(const Image<Rgb>& colour) {
  cv::Mat out(colour.height(), colour.width(), CV_8UC3);
  for (int y = 0; y < out.rows; ++y) {
    for (int x = 0; x < out.cols; ++x) {
      const Rgb c = colour(x, y);
      out.at<cv::Vec3b>(y, x) = {c.b, c.g, c.r};
    }
  }
  return out;
}

cv::Mat mask_pixels(const Image<std::uint16_t>& ids) {
  cv::Mat out(ids.height(), ids.width(), CV_8U);
  for (int y = 0; y < out.rows; ++y) {
    for (int x = 0; x < out.cols; ++x) out.at<std::uint8_t>(y, x) = static_cast<std::uint8_t>(ids(x, y));
  }
  return out;
}

}  // namespace

void write_frame_files(const SetSpec& set, const PlannedFrame& planned, const std::filesystem::path& folder) {
  const PlannedPicture picture = make_planned(set, planned);
  const Size size = picture.exact.depth_m.size();
  const PosedScene posed(picture.view.scene, picture.view.T_world_camera);
  SceneTruth truth = scene_truth(picture.view, posed, picture.exact, picture.camera);
  add_occlusion(truth, picture.view, picture.camera, size);
  write_png_file(folder / "depth" / (planned.id + ".png"), depth_pixels(picture.depth_m));
  write_png_file(folder / "color" / (planned.id + ".png"), colour_pixels(picture.exact.colour));
  write_png_file(folder / "truth" / (planned.id + ".objects.png"), mask_pixels(picture.exact.object_ids));
  write_file_atomically(folder / "truth" / (planned.id + ".json"),
                        annotation_text(truth_of(truth, picture.exact), planned.id + ".png"));
  write_file_atomically(folder / "truth" / (planned.id + ".geometry.json"), geometry_text(truth, picture));
}

bool has_frame_files(const std::string& id, const std::filesystem::path& folder) {
  const std::vector<std::string> names{"depth/" + id + ".png", "color/" + id + ".png",
                                       "truth/" + id + ".objects.png", "truth/" + id + ".json",
                                       "truth/" + id + ".geometry.json"};
  return std::all_of(names.begin(), names.end(), [&](const std::string& name) {
    std::error_code error;
    return std::filesystem::is_regular_file(folder / name, error);
  });
}

std::string shortfall_of(const std::string& id, const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "truth" / (id + ".geometry.json");
  const std::vector<std::uint8_t> bytes = read_file_bytes(file);
  const auto geometry = nlohmann::json::parse(bytes.begin(), bytes.end(), nullptr, false);
  if (!geometry.is_object() || !geometry.contains("objects") || !geometry.contains("objects_requested") ||
      !geometry["objects_requested"].is_number_integer()) {
    throw Error(ErrorKind::data, printable(file) + ": expected objects and objects_requested");
  }
  const auto requested = geometry["objects_requested"].get<std::size_t>(),
             placed = geometry["objects"].size();
  if (placed >= requested) return {};
  return std::to_string(placed) + " of " + std::to_string(requested) + " objects found room";
}

}  // namespace facet
