#include "dataset/frame_checks.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "file/file_bytes.hpp"
#include "file/image_file.hpp"

namespace facet {
namespace {

constexpr float min_focal_widths = 0.3f, max_focal_widths = 5.0f;
constexpr float min_median_m = 0.1f, max_median_m = 20.0f;

template <class... Parts>
void require(bool condition, const std::filesystem::path& path, const Parts&... parts) {
  if (condition) return;
  std::ostringstream message;
  message << printable(path) << ": ";
  (message << ... << parts);
  throw Error(ErrorKind::data, message.str());
}

void check_size(const cv::Mat& image, Size size, const std::filesystem::path& path) {
  const bool same = image.cols == size.width && image.rows == size.height;
  require(same || size.empty(), path, "is ", image.cols, "x", image.rows, " but the depth image is ",
          size.width, "x", size.height);
}

}  // namespace

void check_camera(const Camera& camera, Size size, const std::filesystem::path& path) {
  const auto width = static_cast<float>(size.width);
  const auto height = static_cast<float>(size.height);
  for (const float focal : {camera.fx, camera.fy}) {
    require(focal > 0, path, "intrinsics cannot be right: focal length ", focal, " px is not positive");
    require(focal >= min_focal_widths * width && focal <= max_focal_widths * width, path,
            "intrinsics cannot be right: focal length ", focal, " px is outside 0.3 to 5 image widths (",
            size.width, " px)");
  }
  const bool inside =
      camera.cx >= -0.5f && camera.cx <= width - 0.5f && camera.cy >= -0.5f && camera.cy <= height - 0.5f;
  require(inside, path, "intrinsics cannot be right: principal point (", camera.cx, ", ", camera.cy,
          ") is outside the ", size.width, "x", size.height, " image");
}

void check_depth_unit(const Image<float>& depth_m, const std::filesystem::path& path) {
  std::vector<float> measured;
  for (int y = 0; y < depth_m.height(); ++y)
    std::copy_if(depth_m.row(y), depth_m.row(y) + depth_m.width(), std::back_inserter(measured),
                 [](float depth) { return depth > 0; });
  if (measured.empty()) return;
  const auto middle = measured.begin() + static_cast<std::ptrdiff_t>(measured.size() / 2);
  std::nth_element(measured.begin(), middle, measured.end());
  require(*middle >= min_median_m && *middle <= max_median_m, path,
          "the depth unit cannot be right: the median depth would be ", *middle, " m, outside 0.1 to 20 m");
}

cv::Mat read_registered_color(const std::filesystem::path& path, Size size) {
  const cv::Mat stored = read_image_file(path).pixels;
  check_size(stored, size, path);
  require(stored.depth() == CV_8U, path, "colour must have 8 bits per channel");
  cv::Mat color;
  if (stored.channels() == 1) {
    cv::cvtColor(stored, color, cv::COLOR_GRAY2BGR);
  } else if (stored.channels() == 4) {
    cv::cvtColor(stored, color, cv::COLOR_BGRA2BGR);
  } else {
    color = stored;
  }
  return color;
}

cv::Mat read_object_masks(const std::filesystem::path& path, Size size) {
  const cv::Mat stored = read_image_file(path).pixels;
  check_size(stored, size, path);
  require(stored.type() == CV_8UC1 || stored.type() == CV_16UC1, path,
          "object masks must be one channel of 8-bit or 16-bit integers");
  cv::Mat masks;
  stored.convertTo(masks, CV_16U);
  return masks;
}

}  // namespace facet
