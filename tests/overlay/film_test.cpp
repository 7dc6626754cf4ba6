#include "overlay/film.hpp"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "file/image_file.hpp"
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"
#ifdef FACET_VIDEOIO
#include <opencv2/videoio.hpp>
#endif

namespace facet {
namespace {

namespace fs = std::filesystem;

const cv::Scalar red(0, 0, 255), green(0, 255, 0), white(255, 255, 255);

class FilmFolder : public ::testing::Test {
 protected:
  fs::path picture(const std::string& name, cv::Size size, const cv::Scalar& bgr) {
    const fs::path file = folder_.path() / name;
    write_png_file(file, cv::Mat(size, CV_8UC3, bgr));
    return file;
  }
  TemporaryFolder folder_;
};

/// Whether the middle of a part of the picture has a colour, but for what JPEG makes of it.
void expect_color(const cv::Mat& picture, cv::Point at, const cv::Scalar& bgr) {
  const auto pixel = picture.at<cv::Vec3b>(at);
  for (int channel = 0; channel < 3; ++channel)
    EXPECT_NEAR(pixel[channel], bgr[channel], 6) << at << ", channel " << channel;
}

#ifdef FACET_VIDEOIO
TEST_F(FilmFolder, a_film_shows_its_pictures_in_order_at_a_whole_rate) {
  const fs::path film = folder_.path() / "films/a.avi";
  const cv::Size size{64, 48};
  EXPECT_EQ(write_film(film, {picture("1.png", size, red), picture("2.png", size, green)}, 29.97), 30);
  cv::VideoCapture capture(film.string(), cv::CAP_OPENCV_MJPEG);
  ASSERT_TRUE(capture.isOpened());
  EXPECT_EQ(capture.get(cv::CAP_PROP_FPS), 30);
  cv::Mat shown;
  for (const cv::Scalar& color : {red, green}) {
    ASSERT_TRUE(capture.read(shown));
    EXPECT_EQ(shown.size(), size);
    expect_color(shown, {32, 24}, color);
  }
  EXPECT_FALSE(capture.read(shown));
}

TEST_F(FilmFolder, a_picture_of_another_shape_has_white_beside_it) {
  const fs::path film = folder_.path() / "a.avi";
  write_film(film, {picture("1.png", {64, 48}, red), picture("2.png", {32, 48}, green)}, 10);
  cv::VideoCapture capture(film.string(), cv::CAP_OPENCV_MJPEG);
  cv::Mat shown;
  ASSERT_TRUE(capture.read(shown) && capture.read(shown));
  EXPECT_EQ(shown.size(), cv::Size(64, 48));
  expect_color(shown, {32, 24}, green);
  expect_color(shown, {4, 24}, white);
}

TEST_F(FilmFolder, large_pictures_are_shrunk_to_an_even_size) {
  const fs::path film = folder_.path() / "a.avi";
  write_film(film, {picture("1.png", {1961, 1051}, red)}, 1000);
  const cv::VideoCapture capture(film.string(), cv::CAP_OPENCV_MJPEG);
  EXPECT_EQ(capture.get(cv::CAP_PROP_FRAME_WIDTH), 1280);
  EXPECT_EQ(static_cast<int>(capture.get(cv::CAP_PROP_FRAME_HEIGHT)) % 2, 0);
  EXPECT_EQ(capture.get(cv::CAP_PROP_FPS), 60);
}

TEST_F(FilmFolder, a_film_is_there_whole_or_not_at_all) {
  const fs::path first = picture("1.png", {64, 48}, red);
  expect_error(ErrorKind::data, "none.png: file is missing", [&] {
    write_film(folder_.path() / "films/a.avi", {first, folder_.path() / "none.png"}, 10);
  });
  EXPECT_TRUE(fs::is_empty(folder_.path() / "films"));
}
#else
TEST_F(FilmFolder, without_videoio_says_how_to_get_it) {
  expect_error(ErrorKind::not_measured, "libopencv-dev", [&] { write_film("a.avi", {}, 10); });
}
#endif

TEST_F(FilmFolder, a_contact_sheet_shows_its_pictures_in_reading_order) {
  const cv::Size size{64, 48};
  const cv::Mat sheet = draw_contact_sheet({{"a", picture("1.png", size, red)},
                                            {"b", picture("2.png", size, green)},
                                            {"c", picture("3.png", {48, 48}, green)}});
  EXPECT_GT(sheet.cols, 2 * 960);
  expect_color(sheet, {sheet.cols / 4, sheet.rows / 4}, red);
  expect_color(sheet, {3 * sheet.cols / 4, sheet.rows / 4}, green);
  expect_color(sheet, {sheet.cols / 4, 3 * sheet.rows / 4}, green);
  expect_color(sheet, {3 * sheet.cols / 4, 3 * sheet.rows / 4}, white);
}

}  // namespace
}  // namespace facet
