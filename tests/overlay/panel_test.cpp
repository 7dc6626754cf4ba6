#include "overlay/panel.hpp"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "overlay/example_frame.hpp"

namespace facet {
namespace {

TEST(Panel, keeps_the_aspect_and_fits_into_640_pixels) {
  EXPECT_EQ(PanelGeometry({640, 480}).panel_size, cv::Size(640, 480));
  EXPECT_EQ(PanelGeometry({1920, 1080}).panel_size, cv::Size(640, 360));
  EXPECT_EQ(PanelGeometry({31, 62}).panel_size, cv::Size(320, 640));
  EXPECT_EQ(PanelGeometry({1, 1}).panel_size, cv::Size(640, 640));
  EXPECT_EQ(PanelGeometry({10000, 1}).panel_size, cv::Size(640, 1));
}

TEST(Panel, maps_pixel_centres_to_the_middle_of_their_squares) {
  const PanelGeometry geometry({64, 48});  // every pixel becomes 10 x 10
  EXPECT_EQ(geometry.to_panel(0, 0), cv::Point2d(4.5, 4.5));
  EXPECT_EQ(geometry.to_panel(63, 47), cv::Point2d(634.5, 474.5));
}

TEST(Panel, shows_colour_where_there_is_some_and_grey_depth_otherwise) {
  Frame frame = example_frame({64, 48});
  frame.depth_m(0, 0) = 0;
  const cv::Mat grey = draw_color(frame);
  EXPECT_EQ(grey.at<cv::Vec3b>(0, 0), cv::Vec3b(0, 0, 0));
  EXPECT_GT(grey.at<cv::Vec3b>(400, 400)[0], 50);
  frame.color = cv::Mat(48, 64, CV_8UC3, cv::Scalar(9, 99, 199));
  EXPECT_EQ(draw_color(frame).at<cv::Vec3b>(240, 320), cv::Vec3b(9, 99, 199));
}

TEST(Panel, ground_is_grey_and_darker) {
  Frame frame = example_frame({64, 48});
  frame.color = cv::Mat(48, 64, CV_8UC3, cv::Scalar(9, 99, 199));
  const auto pixel = draw_ground(frame, 0.5).at<cv::Vec3b>(240, 320);
  EXPECT_EQ(pixel[0], pixel[1]);
  EXPECT_EQ(pixel[1], pixel[2]);
  EXPECT_LT(pixel[0], 90);
  EXPECT_GT(pixel[0], 20);
}

TEST(Panel, has_title_and_legend_above_the_picture) {
  const cv::Mat panel(48, 640, CV_8UC3, cv::Scalar(1, 2, 3));
  const cv::Mat framed = with_title(panel, "Title", {{"red", cv::Scalar(0, 0, 255)}});
  ASSERT_GT(framed.rows, panel.rows);
  EXPECT_EQ(framed.cols, 640);
  EXPECT_EQ(framed.at<cv::Vec3b>(framed.rows - 1, 0), cv::Vec3b(1, 2, 3));
  cv::Mat red;
  cv::inRange(framed, cv::Scalar(0, 0, 255), cv::Scalar(0, 0, 255), red);
  EXPECT_GT(cv::countNonZero(red), 100);
  cv::Mat dark;
  cv::inRange(framed(cv::Rect(0, 0, 100, framed.rows - panel.rows)), cv::Scalar::all(0), cv::Scalar::all(80),
              dark);
  EXPECT_GT(cv::countNonZero(dark), 20) << "the title is not there";
}

}  // namespace
}  // namespace facet
