#include "dataset/depth_image.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "dataset/image_folder.hpp"
#include "file/file_bytes.hpp"
#include "support/expect_error.hpp"

namespace facet {
namespace {

constexpr float inf = std::numeric_limits<float>::infinity();

cv::Mat floats(const std::vector<float>& values) {
  return cv::Mat(values, true).reshape(1, 1);
}

TEST(DepthImage, millimetres_become_metres_and_codes_become_missing) {
  const ImageFolder folder;
  cv::Mat raw = (cv::Mat_<std::uint16_t>(1, 5) << 0, 1, 1500, 65534, 65535);
  folder.write("d.png", raw);
  const std::vector<double> codes{65535, 1};
  const DepthImage depth = read_depth_image(folder.path() / "d.png", 0.001, codes);
  ASSERT_EQ(depth.depth_m.size(), (Size{5, 1}));
  EXPECT_EQ(depth.missing_px, 3u);
  EXPECT_EQ(depth.depth_m(0, 0), 0);
  EXPECT_EQ(depth.depth_m(1, 0), 0);
  EXPECT_FLOAT_EQ(depth.depth_m(2, 0), 1.5f);
  EXPECT_FLOAT_EQ(depth.depth_m(3, 0), 65.534f);
  EXPECT_EQ(depth.depth_m(4, 0), 0);
}

TEST(DepthImage, sixteen_bit_integers_are_kept_and_give_the_metres_to_the_bit) {
  const ImageFolder folder;
  cv::Mat raw(256, 256, CV_16UC1);
  for (int i = 0; i < 65536; ++i) raw.at<std::uint16_t>(i / 256, i % 256) = static_cast<std::uint16_t>(i);
  folder.write("d.png", raw);
  const std::vector<double> codes{65535, 1};
  for (const double unit_m : {0.001, 0.0002, 0.000125, 1.0 / 3}) {
    const DepthImage depth = read_depth_image(folder.path() / "d.png", unit_m, codes);
    const auto counted = depth.counted.view();
    ASSERT_TRUE(counted);
    for (int y = 0; y < 256; ++y)
      for (int x = 0; x < 256; ++x)
        ASSERT_EQ(metres_of(counted->counts(x, y), counted->unit_m), depth.depth_m(x, y)) << x << ' ' << y;
  }
}

TEST(DepthImage, floats_have_no_counts) {
  const ImageFolder folder;
  folder.write("d.tiff", floats({1.0f, 2.0f}));
  EXPECT_FALSE(read_depth_image(folder.path() / "d.tiff", 1.0, {}).counted.view());
}

TEST(DepthImage, without_its_code_65535_is_a_depth) {
  const ImageFolder folder;
  folder.write_depth("d.png", 65535, 1, 1);
  EXPECT_FLOAT_EQ(read_depth_image(folder.path() / "d.png", 0.001, {}).depth_m(0, 0), 65.535f);
}

TEST(DepthImage, nan_and_infinities_of_float_images_are_missing) {
  const ImageFolder folder;
  folder.write("d.tiff", floats({std::nanf(""), inf, -inf, 0.0f, -0.0f, 1.25f, -1.0f, 3e38f}));
  const std::vector<double> codes{-1};
  const DepthImage depth = read_depth_image(folder.path() / "d.tiff", 2.0, codes);
  EXPECT_EQ(depth.missing_px, 7u);  // 3e38 units are beyond the largest float
  for (int x = 0; x < 8; ++x) EXPECT_EQ(depth.depth_m(x, 0), x == 5 ? 2.5f : 0.0f) << x;
}

TEST(DepthImage, negative_depth_is_an_error_that_names_the_pixel) {
  const ImageFolder folder;
  folder.write("d.tiff", floats({1.0f, 2.0f, -0.5f}));
  expect_error(ErrorKind::data, "d.tiff: negative depth -0.500000 at pixel (2, 0)",
               [&] { read_depth_image(folder.path() / "d.tiff", 1.0, {}); });
}

TEST(DepthImage, another_pixel_type_is_an_error_that_names_it) {
  const ImageFolder folder;
  const auto expect_refused = [&](const std::string& name, const std::string& kind) {
    expect_error(ErrorKind::data,
                 name + ": depth must be one channel of 16-bit integers or 32-bit floats, this is a " + kind,
                 [&] { read_depth_image(folder.path() / name, 0.001, {}); });
  };
  folder.write("grey.png", cv::Mat(2, 2, CV_8U, cv::Scalar(1)));
  expect_refused("grey.png", "8-bit grey image");
  folder.write("colour.png", cv::Mat(2, 2, CV_16UC3, cv::Scalar(1)));
  expect_refused("colour.png", "16-bit colour image");
  folder.write("double.tiff", cv::Mat(2, 2, CV_64F, cv::Scalar(1)));
  expect_refused("double.tiff", "CV_64FC1 image");
  folder.write("jpeg.jpg", cv::Mat(8, 8, CV_8U, cv::Scalar(1)));
  expect_refused("jpeg.jpg", "CV_8UC1 image");
}

TEST(DepthImage, a_float_image_broken_off_anywhere_is_an_error) {
  const ImageFolder folder;
  cv::Mat image(48, 64, CV_32F);
  for (int y = 0; y < image.rows; ++y)
    for (int x = 0; x < image.cols; ++x)
      image.at<float>(y, x) = 1.0f + 0.01f * static_cast<float>(x * y % 37);
  folder.write("d.tiff", image);
  const auto path = folder.path() / "d.tiff";
  const auto whole = read_file_bytes(path);
  for (std::size_t size = 1; size < whole.size(); size += 37) {
    write_file_atomically(path, std::span(whole).first(size));
    expect_error(ErrorKind::data, "d.tiff: ", [&] { read_depth_image(path, 1.0, {}); });
  }
}

}  // namespace
}  // namespace facet
