#include "experiment/calibration.hpp"

#include <algorithm>
#include <chrono>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/random.hpp"

namespace facet {
namespace {

cv::Mat fixed_image() {
  cv::Mat image(480, 640, CV_32F);
  for (int y = 0; y < image.rows; ++y)
    for (int x = 0; x < image.cols; ++x)
      image.at<float>(y, x) = random_uniform(1, 0, static_cast<std::uint64_t>(y * image.cols + x));
  return image;
}

}  // namespace

struct CalibrationBlock::Images {
  cv::Mat input = fixed_image();
  cv::Mat blurred, gradient, filtered;
};

CalibrationBlock::CalibrationBlock() : images_(std::make_unique<Images>()) {}

CalibrationBlock::~CalibrationBlock() = default;

double CalibrationBlock::run_ms() {
  Images& images = *images_;
  const auto start = std::chrono::steady_clock::now();
  cv::GaussianBlur(images.input, images.blurred, {5, 5}, 1.2);
  cv::Sobel(images.blurred, images.gradient, CV_32F, 1, 0, 3);
  cv::medianBlur(images.input, images.filtered, 5);
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

Calibration measure_calibration() {
  constexpr int repeats = 31;
  CalibrationBlock block;
  std::vector<double> ms;
  for (int i = 0; i < repeats; ++i) ms.push_back(block.run_ms());
  std::sort(ms.begin(), ms.end());
  return {repeats, ms[repeats / 2], ms.front()};
}

}  // namespace facet
