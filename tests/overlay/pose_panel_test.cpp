#include "overlay/pose_panel.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "overlay/example_frame.hpp"

namespace facet {
namespace {

const std::map<int, cv::Scalar> white_contours{{1, cv::Scalar::all(255)}};
constexpr Size size{64, 48};

/// Centre of the pixels that have exactly the colour of an axis.
cv::Point2d centre_of_axis(const cv::Mat& panel, std::size_t axis) {
  cv::Mat found;
  cv::inRange(panel, axis_colors[axis], axis_colors[axis], found);
  const cv::Moments moments = cv::moments(found, true);
  EXPECT_GT(moments.m00, 0) << "axis " << axis << " is not drawn";
  return {moments.m10 / moments.m00, moments.m01 / moments.m00};
}

TEST(PosePanel, axes_point_where_the_quaternion_says) {
  // Half a turn about x: x stays right, y points up in the image, z towards the camera.
  Prediction prediction = half_prediction(size);
  prediction.surfaces[0].pose->quaternion_wxyz = {0, 1, 0, 0};
  const cv::Mat panel = draw_poses(example_frame(size), prediction, white_contours);
  const cv::Point2d origin = PanelGeometry(size).to_panel(31.5, 23.5);
  EXPECT_GT(centre_of_axis(panel, 0).x, origin.x + 10);
  EXPECT_NEAR(centre_of_axis(panel, 0).y, origin.y, 1.5);
  EXPECT_LT(centre_of_axis(panel, 1).y, origin.y - 10);
  EXPECT_NEAR(centre_of_axis(panel, 1).x, origin.x, 1.5);
}

TEST(PosePanel, a_quarter_turn_about_z_turns_x_into_down) {
  const auto half = static_cast<float>(std::sqrt(0.5));
  Prediction prediction = half_prediction(size);
  prediction.surfaces[0].pose->quaternion_wxyz = {half, 0, 0, half};
  const cv::Mat panel = draw_poses(example_frame(size), prediction, white_contours);
  const cv::Point2d origin = PanelGeometry(size).to_panel(31.5, 23.5);
  EXPECT_GT(centre_of_axis(panel, 0).y, origin.y + 10);
  EXPECT_LT(centre_of_axis(panel, 1).x, origin.x - 10);
}

TEST(PosePanel, contours_are_drawn_along_their_pixels) {
  const cv::Mat panel = draw_poses(example_frame(size), half_prediction(size), white_contours);
  const cv::Point2d on_outline = PanelGeometry(size).to_panel(32, 10);
  EXPECT_GT(panel.at<cv::Vec3b>(on_outline)[0], 200);
}

TEST(PosePanel, poses_that_cannot_be_drawn_are_left_out) {
  const Frame frame = example_frame(size);
  Prediction prediction = half_prediction(size);
  prediction.surfaces[0].pose.reset();
  const cv::Mat without = draw_poses(frame, prediction, white_contours);
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  for (const Vec3 centre :
       {Vec3{0, 0, -1}, Vec3{0, 0, 0}, Vec3{nan, 0, 1}, Vec3{0, 0, inf}, Vec3{inf, 0, 1}}) {
    prediction.surfaces[0].pose = SurfacePose{centre, {1, 0, 0, 0}, {}, {1, 0, 0}};
    EXPECT_EQ(cv::norm(without, draw_poses(frame, prediction, white_contours), cv::NORM_INF), 0);
  }
  prediction.surfaces[0].pose = SurfacePose{{1e30f, 0, 1}, {1, 0, 0, 0}, {}, {1, 0, 0}};
  EXPECT_EQ(draw_poses(frame, prediction, white_contours).size(), without.size());
}

TEST(PosePanel, the_best_grasp_is_a_line_between_its_contacts) {
  const Frame frame = example_frame(size);
  Prediction prediction = half_prediction(size);
  const cv::Mat without = draw_poses(frame, prediction, white_contours);
  prediction.surfaces[0].grasps.resize(2);
  prediction.surfaces[0].grasps[0].contacts_px = {ImagePoint{36, 40}, ImagePoint{60, 40}};
  prediction.surfaces[0].grasps[1].contacts_px = {ImagePoint{36, 8}, ImagePoint{60, 8}};
  const cv::Mat panel = draw_poses(frame, prediction, white_contours);
  const PanelGeometry geometry(size);
  const auto differs_at = [&](double x, double y) {
    const cv::Point p(geometry.to_panel(x, y));
    return panel.at<cv::Vec3b>(p) != without.at<cv::Vec3b>(p);
  };
  for (const double x : {36.0, 48.0, 60.0}) {
    EXPECT_TRUE(differs_at(x, 40)) << x;
    EXPECT_FALSE(differs_at(x, 8)) << x;
  }
  const cv::Point contact(geometry.to_panel(36, 40));
  EXPECT_LT(cv::norm(cv::Scalar(panel.at<cv::Vec3b>(contact)) - grasp_color, cv::NORM_INF), 30);
}

TEST(PosePanel, grasps_that_cannot_be_drawn_are_left_out) {
  const Frame frame = example_frame(size);
  Prediction prediction = half_prediction(size);
  const cv::Mat without = draw_poses(frame, prediction, white_contours);
  prediction.surfaces[0].grasps.resize(1);
  prediction.surfaces[0].grasps[0].contacts_px[1].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(cv::norm(without, draw_poses(frame, prediction, white_contours), cv::NORM_INF), 0);
}

}  // namespace
}  // namespace facet
