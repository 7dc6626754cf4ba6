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

Calibration measure_calibration() {
  constexpr int repeats = 31;
  const cv::Mat image = fixed_image();
  cv::Mat blurred, gradient, filtered;
  std::vector<double> ms;
  for (int i = 0; i < repeats; ++i) {
    const auto start = std::chrono::steady_clock::now();
    cv::GaussianBlur(image, blurred, {5, 5}, 1.2);
    cv::Sobel(blurred, gradient, CV_32F, 1, 0, 3);
    cv::medianBlur(image, filtered, 5);
    ms.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  }
  std::sort(ms.begin(), ms.end());
  return {repeats, ms[repeats / 2], ms.front()};
}

}  // namespace facet
