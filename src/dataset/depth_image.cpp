#include "dataset/depth_image.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>

#include "core/error.hpp"
#include "file/file_bytes.hpp"
#include "file/image_file.hpp"

namespace facet {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& rule) {
  throw Error(ErrorKind::data, printable(path) + ": " + rule);
}

void check_type(const ImageFile& image, const std::filesystem::path& path) {
  const int type = image.pixels.type();
  if (type == CV_16UC1 || type == CV_32FC1) return;
  const std::string found = image.png ? image.png->kind() : cv::typeToString(type) + " image";
  fail(path, "depth must be one channel of 16-bit integers or 32-bit floats, this is a " + found);
}

template <class Raw>
DepthImage to_metres(const cv::Mat& raw, double unit_m, std::span<const double> codes,
                     const std::filesystem::path& path) {
  DepthImage result{Image<float>(Size{raw.cols, raw.rows}), {}, 0};
  for (int y = 0; y < raw.rows; ++y) {
    for (int x = 0; x < raw.cols; ++x) {
      const double value = raw.at<Raw>(y, x);
      const bool coded = std::find(codes.begin(), codes.end(), value) != codes.end();
      if (!coded && std::isfinite(value) && value < 0)
        fail(path, "negative depth " + std::to_string(value) + " at pixel (" + std::to_string(x) + ", " +
                       std::to_string(y) + ")");
      const float depth_m = coded ? 0.0f : static_cast<float>(value * unit_m);
      const bool measured = std::isfinite(depth_m) && depth_m > 0;
      result.depth_m(x, y) = measured ? depth_m : 0.0f;
      result.missing_px += !measured;
    }
  }
  return result;
}

CountedDepth counted(const cv::Mat& raw, double unit_m, const Image<float>& depth_m) {
  CountedDepth result{Image<std::uint16_t>(depth_m.size()), unit_m};
  for (int y = 0; y < depth_m.height(); ++y)
    for (int x = 0; x < depth_m.width(); ++x)
      result.counts(x, y) = depth_m(x, y) > 0 ? raw.at<std::uint16_t>(y, x) : std::uint16_t{0};
  return result;
}

}  // namespace

DepthImage read_depth_image(const std::filesystem::path& path, double depth_unit_m,
                            std::span<const double> missing_codes) {
  const ImageFile image = read_image_file(path);
  check_type(image, path);
  if (image.pixels.type() == CV_32FC1)
    return to_metres<float>(image.pixels, depth_unit_m, missing_codes, path);
  DepthImage depth = to_metres<std::uint16_t>(image.pixels, depth_unit_m, missing_codes, path);
  depth.counted = counted(image.pixels, depth_unit_m, depth.depth_m);
  return depth;
}

}  // namespace facet
