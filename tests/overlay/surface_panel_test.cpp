#include "overlay/surface_panel.hpp"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "overlay/example_frame.hpp"

namespace facet {
namespace {

TEST(SurfacePanel, a_surface_takes_its_colour_and_the_rest_stays_grey) {
  const Size size{64, 48};
  const Frame frame = example_frame(size);
  const cv::Mat panel = draw_surfaces(frame, half_prediction(size), {{1, cv::Scalar(0, 0, 255)}});
  const auto left = panel.at<cv::Vec3b>(100, 100), right = panel.at<cv::Vec3b>(100, 500);
  EXPECT_EQ(left, draw_ground(frame, 0.8).at<cv::Vec3b>(100, 100));
  EXPECT_GT(right[2], right[0] + 100);
  EXPECT_EQ(panel.at<cv::Vec3b>(100, 319), cv::Vec3b(255, 255, 255)) << "a white line separates them";
}

TEST(SurfacePanel, the_id_is_written_only_where_it_fits) {
  const Size size{64, 48};
  const std::map<int, cv::Scalar> colors{{1, cv::Scalar(0, 0, 255)}};
  const auto black_pixels = [&](const Prediction& prediction) {
    cv::Mat black;
    cv::inRange(draw_surfaces(example_frame(size), prediction, colors), cv::Scalar::all(0),
                cv::Scalar::all(30), black);
    return cv::countNonZero(black);
  };
  EXPECT_GT(black_pixels(half_prediction(size)), 5);
  Prediction tiny = empty_prediction(size);
  tiny.labels(3, 3) = 1;
  tiny.surfaces.resize(1);
  tiny.surfaces[0].id = 1;
  EXPECT_EQ(black_pixels(tiny), 0);
}

}  // namespace
}  // namespace facet
