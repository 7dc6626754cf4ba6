#include "file/image_file.hpp"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "file/file_bytes.hpp"
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

namespace facet {
namespace {

cv::Mat ramp_16_bit(int width, int height) {
  cv::Mat image(height, width, CV_16U);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image.at<std::uint16_t>(y, x) = static_cast<std::uint16_t>(97 * x + 1009 * y);
  return image;
}

TEST(ImageFile, a_16_bit_image_comes_back_unchanged_however_it_was_written) {
  const TemporaryFolder folder;
  const cv::Mat written = ramp_16_bit(31, 7);
  for (const PngEffort effort : {PngEffort::least_space, PngEffort::least_time}) {
    write_png_file(folder.path() / "a.png", written, effort);
    const ImageFile read = read_image_file(folder.path() / "a.png");
    ASSERT_TRUE(read.png.has_value());
    EXPECT_EQ(read.png->width, 31u);
    EXPECT_EQ(read.png->height, 7u);
    EXPECT_EQ(read.png->kind(), "16-bit grey image");
    ASSERT_EQ(read.pixels.type(), CV_16UC1);
    EXPECT_EQ(cv::norm(read.pixels, written, cv::NORM_INF), 0);
  }
}

TEST(ImageFile, a_png_broken_off_at_any_byte_is_refused) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.png";
  write_png_file(path, ramp_16_bit(64, 48));
  const auto whole = read_file_bytes(path);
  ASSERT_GT(whole.size(), 100u);
  for (std::size_t size = 1; size < whole.size(); ++size) {
    write_file_atomically(path, std::span(whole).first(size));
    expect_error(ErrorKind::data, "a.png: ", [&] { read_image_file(path); });
  }
}

TEST(ImageFile, a_png_with_any_byte_flipped_is_refused) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.png";
  write_png_file(path, ramp_16_bit(16, 12));
  const auto whole = read_file_bytes(path);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    auto broken = whole;
    broken[i] ^= 0x10;
    write_file_atomically(path, broken);
    expect_error(ErrorKind::data, "a.png: ", [&] { read_image_file(path); });
  }
}

TEST(ImageFile, bytes_after_the_end_of_a_png_do_no_harm) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.png";
  write_png_file(path, ramp_16_bit(3, 2));
  auto bytes = read_file_bytes(path);
  bytes.push_back(0);
  write_file_atomically(path, bytes);
  EXPECT_EQ(read_image_file(path).pixels.cols, 3);
}

TEST(ImageFile, something_else_than_an_image_is_refused) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.png";
  write_file_atomically(path, std::string_view("<html>404</html>"));
  expect_error(ErrorKind::data, "a.png: image cannot be decoded", [&] { read_image_file(path); });
}

}  // namespace
}  // namespace facet
