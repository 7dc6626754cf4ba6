#include "overlay/edge_panel.hpp"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "overlay/example_frame.hpp"

namespace facet {
namespace {

cv::Vec3b bytes_of(const cv::Scalar& color) {
  return {cv::saturate_cast<std::uint8_t>(color[0]), cv::saturate_cast<std::uint8_t>(color[1]),
          cv::saturate_cast<std::uint8_t>(color[2])};
}

int count(const cv::Mat& panel, std::uint8_t code) {
  cv::Mat found;
  const cv::Vec3b color = bytes_of(edge_color(code));
  cv::inRange(panel, cv::Scalar(color), cv::Scalar(color), found);
  return cv::countNonZero(found);
}

TEST(EdgePanel, every_kind_has_its_own_colour_where_it_lies) {
  const Size size{64, 48};
  Prediction prediction = empty_prediction(size);
  const std::array<std::uint8_t, 5> codes{1, 2, 3, 17, 18};
  for (std::size_t i = 0; i < codes.size(); ++i)
    prediction.edges(static_cast<int>(10 * i + 5), 20) = codes[i];
  const cv::Mat panel = draw_edges(example_frame(size), prediction);
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const cv::Point2d centre = PanelGeometry(size).to_panel(static_cast<double>(10 * i + 5), 20);
    EXPECT_EQ(panel.at<cv::Vec3b>(centre), bytes_of(edge_color(codes[i]))) << int{codes[i]};
    EXPECT_EQ(count(panel, codes[i]), 100) << "one pixel of the image is 10 x 10 of the panel";
  }
}

TEST(EdgePanel, red_is_depth_green_is_convex_blue_is_concave) {
  const auto depth = edge_color(1), convex = edge_color(2), concave = edge_color(3);
  EXPECT_GT(depth[2], depth[0] + depth[1]);
  EXPECT_GT(convex[1], convex[0] + convex[2]);
  EXPECT_GT(concave[0], concave[1] + concave[2] - 1);
  EXPECT_GT(edge_color(17)[2], edge_color(1)[2]);
  EXPECT_GT(edge_color(18)[1], edge_color(2)[1]);
}

TEST(EdgePanel, graspable_edges_of_a_large_image_stay_thick) {
  const Size size{1920, 1080};
  Prediction prediction = empty_prediction(size);
  prediction.edges(960, 540) = 17;
  prediction.edges(300, 540) = 1;
  const cv::Mat panel = draw_edges(example_frame(size), prediction);
  EXPECT_EQ(count(panel, 17), 9);
  EXPECT_EQ(count(panel, 1), 4);
}

TEST(EdgePanel, edges_at_the_border_stay_inside) {
  const Size size{640, 480};
  Prediction prediction = empty_prediction(size);
  prediction.edges(0, 0) = prediction.edges(639, 479) = 17;
  EXPECT_GT(count(draw_edges(example_frame(size), prediction), 17), 4);
}

TEST(EdgePanel, without_edges_there_is_the_ground_alone) {
  const Size size{64, 48};
  Prediction prediction = empty_prediction(size);
  const cv::Mat with = draw_edges(example_frame(size), prediction);
  prediction.edges = Image<std::uint8_t>();
  EXPECT_EQ(cv::norm(with, draw_edges(example_frame(size), prediction), cv::NORM_INF), 0);
}

}  // namespace
}  // namespace facet
