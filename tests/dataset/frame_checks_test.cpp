#include "dataset/frame_checks.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "dataset/image_folder.hpp"
#include "support/expect_error.hpp"

namespace facet {
namespace {

TEST(FrameChecks, cameras_of_known_sensors_pass) {
  check_camera({525, 525, 319.5f, 239.5f}, {640, 480}, "f");
  check_camera({944.167f, 939.11f, 956.857f, 552.318f}, {1920, 1080}, "f");
  check_camera({192, 3200, -0.5f, 479.5f}, {640, 480}, "f");  // at the limits
  check_camera({1, 1, 0, 0}, {1, 1}, "f");
}

TEST(FrameChecks, cameras_that_cannot_be_right_are_refused) {
  const auto expect_refused = [](const Camera& camera, const std::string& part) {
    expect_error(ErrorKind::data, "f: intrinsics cannot be right: " + part, [&] {
      check_camera(camera, {640, 480}, "f");
    });
  };
  expect_refused({0, 525, 320, 240}, "focal length 0 px is not positive");
  expect_refused({525, -1, 320, 240}, "focal length -1 px is not positive");
  expect_refused({std::nanf(""), 525, 320, 240}, "focal length nan px is not positive");
  expect_refused({191, 525, 320, 240}, "focal length 191 px is outside 0.3 to 5 image widths");
  expect_refused({525, 3201, 320, 240}, "focal length 3201 px is outside 0.3 to 5 image widths");
  expect_refused({525, 525, 640, 240}, "principal point (640, 240) is outside the 640x480 image");
  expect_refused({525, 525, 320, -1}, "principal point (320, -1) is outside");
  expect_refused({525, 525, 320, std::nanf("")}, "principal point (320, nan) is outside");
}

TEST(FrameChecks, the_depth_unit_is_judged_by_the_median_of_what_was_measured) {
  Image<float> depth_m(Size{3, 1}, 0.0f);
  check_depth_unit(depth_m, "f");  // nothing measured, nothing to judge
  depth_m(0, 0) = 0.099f;
  expect_error(ErrorKind::data, "f: the depth unit cannot be right: the median depth would be 0.099 m",
               [&] { check_depth_unit(depth_m, "f"); });
  depth_m(1, 0) = 0.1f;
  check_depth_unit(depth_m, "f");
  depth_m(0, 0) = depth_m(2, 0) = 20.1f;
  expect_error(ErrorKind::data, "20.1 m, outside 0.1 to 20 m", [&] { check_depth_unit(depth_m, "f"); });
}

TEST(FrameChecks, colour_of_any_8_bit_kind_becomes_bgr) {
  const ImageFolder folder;
  folder.write("grey.png", cv::Mat(2, 3, CV_8U, cv::Scalar(7)));
  folder.write("alpha.png", cv::Mat(2, 3, CV_8UC4, cv::Scalar(1, 2, 3, 4)));
  const cv::Mat grey = read_registered_color(folder.path() / "grey.png", {3, 2});
  EXPECT_EQ(grey.at<cv::Vec3b>(0, 0), cv::Vec3b(7, 7, 7));
  const cv::Mat alpha = read_registered_color(folder.path() / "alpha.png", {3, 2});
  EXPECT_EQ(alpha.at<cv::Vec3b>(0, 0), cv::Vec3b(1, 2, 3));
}

TEST(FrameChecks, colour_and_masks_must_fit_the_depth_image) {
  const ImageFolder folder;
  folder.write_color("c.png", 4, 2);
  folder.write("deep.png", cv::Mat(2, 3, CV_16UC3, cv::Scalar(1)));
  expect_error(ErrorKind::data, "c.png: is 4x2 but the depth image is 3x2", [&] {
    read_registered_color(folder.path() / "c.png", {3, 2});
  });
  expect_error(ErrorKind::data, "deep.png: colour must have 8 bits", [&] {
    read_registered_color(folder.path() / "deep.png", {3, 2});
  });
  expect_error(ErrorKind::data, "c.png: object masks must be one channel", [&] {
    read_object_masks(folder.path() / "c.png", {4, 2});
  });
}

TEST(FrameChecks, object_masks_keep_their_values) {
  const ImageFolder folder;
  folder.write("m.png", cv::Mat(1, 2, CV_8U, cv::Scalar(200)));
  const cv::Mat masks = read_object_masks(folder.path() / "m.png", {2, 1});
  ASSERT_EQ(masks.type(), CV_16UC1);
  EXPECT_EQ(masks.at<std::uint16_t>(0, 1), 200);
}

}  // namespace
}  // namespace facet
