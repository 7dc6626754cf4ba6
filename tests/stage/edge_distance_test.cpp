#include "stage/edge_distance.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "support/every_executor.hpp"
#include "support/masks.hpp"
#include "support/mat.hpp"

namespace facet {
namespace {

template <class Executor>
Mask distance_of(Executor& executor, const Image<float>& depth, const Mask& edge, int cap) {
  Mask distance(depth.size()), scratch(depth.size(), 77);
  edge_distance(executor, depth.view(), edge.view(), cap, distance.view(), scratch.view());
  return distance;
}

/// Chessboard distance to the nearest zero pixel by OpenCV, where the image lies in a frame of zeros.
cv::Mat_<float> chessboard_distance(const Image<float>& depth, const Mask& edge) {
  const Mask open =
      make_image<std::uint8_t>(depth.size(), [&](int x, int y) { return depth(x, y) > 0 && !edge(x, y); });
  cv::Mat distance;
  cv::distanceTransform(padded_mat(open, 1), distance, cv::DIST_C, 3);
  return distance(cv::Rect(1, 1, depth.width(), depth.height()));
}

TEST(EdgeDistance, IsOpenCVsChessboardDistanceUpToTheCap) {
  const Size size{61, 43};
  CpuExecutor executor;
  for (const int cap : {1, 2, 5, 17}) {
    const auto depth =
        make_image<float>(size, [](int x, int y) { return x > 40 && x < 44 && y > 20 ? 0.0f : 1.0f; });
    const Mask edge = random_mask(size, 4, 0.004f);
    const Mask distance = distance_of(executor, depth, edge, cap);
    const cv::Mat_<float> expected = chessboard_distance(depth, edge);
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x)
        EXPECT_EQ(distance(x, y), std::min(cap, static_cast<int>(expected(y, x)))) << x << ", " << y;
  }
}

TEST(EdgeDistance, LeavesWindowsFreeOfEdgesHolesAndTheImagesEnd) {
  const Size size{61, 43};
  const Image<float> depth = random_depth(size, 6);
  const Mask edge = random_mask(size, 5, 0.002f);
  CpuExecutor executor;
  const Mask distance = distance_of(executor, depth, edge, 9);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      for (int dy = 1 - distance(x, y); dy < distance(x, y); ++dy)
        for (int dx = 1 - distance(x, y); dx < distance(x, y); ++dx) {
          ASSERT_TRUE(size.contains(x + dx, y + dy));
          EXPECT_TRUE(depth(x + dx, y + dy) > 0 && !edge(x + dx, y + dy));
        }
}

TEST(EdgeDistance, IsZeroWhereNothingIsMeasured) {
  CpuExecutor executor;
  const Mask distance = distance_of(executor, Image<float>(Size{33, 9}), Mask(Size{33, 9}), 5);
  EXPECT_TRUE(same_image(distance, Mask(Size{33, 9})));
}

TEST(EdgeDistance, IsTheSameOnEveryExecutor) {
  for_each_awkward_depth([](const Image<float>& depth) {
    const Mask edge = random_mask(depth.size(), 4, 0.01f);
    for (const int cap : {4, 5})
      expect_same_on_every_executor([&](auto& executor) { return distance_of(executor, depth, edge, cap); });
  });
}

}  // namespace
}  // namespace facet
