#include "method/coco_instances.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

#include "core/error.hpp"
#include "file/file_bytes.hpp"
#include "method/frame_names.hpp"

namespace facet {

using Json = nlohmann::json;

struct CocoInstances::Instance {
  double score = 0;
  Json segmentation;
};

namespace {

using Mask = cv::Mat;  // CV_8U, 0 or 1

/// COCO counts column by column, background first.
Mask mask_of_runs(const std::vector<long>& runs, Size size) {
  Mask transposed(size.width, size.height, CV_8U, cv::Scalar(0));
  long at = 0;
  bool inside = false;
  for (const long run : runs) {
    if (run < 0 || at + run > size.area()) throw Error(ErrorKind::data, "its runs do not fit its size");
    if (inside) std::fill_n(transposed.ptr<std::uint8_t>() + at, run, std::uint8_t{1});
    at += run;
    inside = !inside;
  }
  if (at != size.area()) throw Error(ErrorKind::data, "its runs do not fill its size");
  return transposed.t();
}

Mask mask_of_polygons(const Json& polygons, Size size) {
  std::vector<std::vector<cv::Point>> outlines;
  for (const Json& polygon : polygons) {
    const auto numbers = polygon.get<std::vector<double>>();
    if (numbers.size() < 6 || numbers.size() % 2 != 0)
      throw Error(ErrorKind::data, "a polygon needs three points");
    auto& outline = outlines.emplace_back();
    // COCO's pixel 0 covers [0, 1).
    for (std::size_t i = 0; i < numbers.size(); i += 2)
      outline.emplace_back(cvRound(numbers[i] - 0.5), cvRound(numbers[i + 1] - 0.5));
  }
  Mask mask(size.height, size.width, CV_8U, cv::Scalar(0));
  cv::fillPoly(mask, outlines, cv::Scalar(1));
  return mask;
}

Mask mask_of(const Json& segmentation, Size size) {
  if (segmentation.is_array()) return mask_of_polygons(segmentation, size);
  const auto stated = segmentation.at("size").get<std::vector<int>>();
  if (stated != std::vector<int>{size.height, size.width})
    throw Error(ErrorKind::data, "its size [height, width] is not that of the frame");
  const Json& counts = segmentation.at("counts");
  return mask_of_runs(
      counts.is_string() ? decode_coco_runs(counts.get<std::string>()) : counts.get<std::vector<long>>(),
      size);
}

std::string without_ending(const std::string& file_name) {
  std::filesystem::path path(file_name);
  return path.replace_extension().generic_string();
}

}  // namespace

std::vector<long> decode_coco_runs(const std::string& text) {
  std::vector<long> runs;
  for (std::size_t i = 0; i < text.size();) {
    long value = 0;
    int shift = 0;
    bool more = true;
    while (more) {
      if (i == text.size() || shift > 55 || text[i] < 48 || text[i] > 111)
        throw Error(ErrorKind::data, "its counts are no run lengths of COCO");
      const long bits = text[i++] - 48;
      value |= (bits & 0x1f) << shift;
      shift += 5;
      more = (bits & 0x20) != 0;
      if (!more && (bits & 0x10) != 0) value |= -1L << shift;  // its sign
    }
    if (runs.size() > 2) value += runs[runs.size() - 2];
    runs.push_back(value);
  }
  return runs;
}

CocoInstances::CocoInstances(std::filesystem::path file, const std::string& frame_id)
    : file_(std::move(file)) {
  const auto bytes = read_file_bytes(file_);
  try {
    Json json = Json::parse(bytes.begin(), bytes.end());
    std::map<int, std::string> names;
    if (json.is_object())
      for (const Json& image : json.at("images")) {
        const std::string name = without_ending(image.at("file_name").get<std::string>());
        names[image.at("id").get<int>()] = name;
        instances_[name];  // one without instances is a frame with nothing in it
      }
    for (Json& item : json.is_object() ? json.at("annotations") : json) {
      const int image = item.at("image_id").get<int>();
      const auto named = names.find(image);
      if (named == names.end() && json.is_object())
        throw Error(ErrorKind::data, "image_id " + std::to_string(image) + " is none of the images");
      const std::string frame = named != names.end() ? named->second : frame_named(frame_id, 0, image);
      instances_[frame].push_back({item.value("score", 1.0), std::move(item.at("segmentation"))});
    }
  } catch (const Json::exception& e) {
    throw Error(ErrorKind::data, printable(file_) + ": " + e.what());
  } catch (const Error& e) {
    throw Error(e.kind(), printable(file_) + ": " + e.what());
  }
}
CocoInstances::~CocoInstances() = default;
CocoInstances::CocoInstances(CocoInstances&&) noexcept = default;

Image<std::uint16_t> CocoInstances::labels_of(const std::string& frame, Size size) const {
  Image<std::uint16_t> labels(size, 0);
  const auto found = instances_.find(frame);
  if (found == instances_.end()) return labels;
  const std::vector<Instance>& instances = found->second;
  Image<float> score(size, 0);
  for (std::size_t i = 0; i < instances.size(); ++i) {
    Mask mask;
    try {
      mask = mask_of(instances[i].segmentation, size);
    } catch (const std::exception& e) {  // ours and those of the JSON library
      throw Error(ErrorKind::data, printable(file_) + ": segmentation " + std::to_string(i + 1) +
                                       " of frame " + frame + ": " + e.what());
    }
    const auto own = static_cast<float>(instances[i].score);
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) {
        if (mask.at<std::uint8_t>(y, x) == 0 || (labels(x, y) != 0 && own <= score(x, y))) continue;
        labels(x, y) = static_cast<std::uint16_t>(i + 1);
        score(x, y) = own;
      }
  }
  return labels;
}

std::vector<std::string> CocoInstances::frames() const {
  std::vector<std::string> names;
  for (const auto& [name, instances] : instances_) names.push_back(name);
  return names;
}

}  // namespace facet
