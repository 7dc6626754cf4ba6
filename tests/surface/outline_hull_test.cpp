#include "surface/outline_hull.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "core/random.hpp"

namespace facet {
namespace {

/// Each once.
std::vector<std::pair<int, int>> sorted(const std::vector<ContourPoint>& points) {
  std::vector<std::pair<int, int>> pairs;
  for (const ContourPoint& p : points) pairs.emplace_back(p.x, p.y);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

std::vector<cv::Point> to_cv(const std::vector<ContourPoint>& points) {
  std::vector<cv::Point> converted;
  for (const ContourPoint& p : points) converted.emplace_back(p.x, p.y);
  return converted;
}

Polyline random_points(std::uint64_t seed, std::size_t count, std::uint32_t extent) {
  Polyline points;
  for (std::uint64_t i = 0; i < count; ++i)
    points.push_back({static_cast<int>(random_below(extent, seed, 0, i)),
                      static_cast<int>(random_below(extent / 2 + 1, seed, 1, i))});
  return points;
}

TEST(OutlineHull, HasTheCornersThatOpenCVFinds) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Polyline points = random_points(seed, 1 + seed % 40, seed % 3 == 0 ? 4 : 60);
    std::vector<cv::Point> hull;
    cv::convexHull(to_cv(points), hull);
    Polyline expected;
    for (const cv::Point& p : hull) expected.push_back({p.x, p.y});
    EXPECT_EQ(sorted(convex_corners(points)), sorted(expected)) << seed;
  }
}

TEST(OutlineHull, HasTheRectangleOfTheWholeOutlineToTheBit) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Polyline points = random_points(seed, 3 + seed % 90, 50);
    const cv::RotatedRect whole = cv::minAreaRect(to_cv(points)),
                          corners = cv::minAreaRect(to_cv(convex_corners(points)));
    EXPECT_EQ(whole.center, corners.center) << seed;
    EXPECT_EQ(whole.size, corners.size) << seed;
    EXPECT_EQ(whole.angle, corners.angle) << seed;
  }
}

TEST(OutlineHull, KeepsTheOrderOfTheOutlineAndWhatItPassesTwice) {
  const Polyline outline{{0, 0}, {1, 0}, {2, 0}, {1, 0}, {0, 0}, {1, 2}};
  EXPECT_EQ(convex_corners(outline), (Polyline{{0, 0}, {2, 0}, {0, 0}, {1, 2}}));
}

TEST(OutlineHull, OfALineIsItsEnds) {
  EXPECT_EQ(sorted(convex_corners({{3, 5}, {4, 5}, {5, 5}, {4, 5}})),
            (std::vector<std::pair<int, int>>{{3, 5}, {5, 5}}));
  EXPECT_EQ(sorted(convex_corners({{3, 5}, {3, 6}, {3, 7}})),
            (std::vector<std::pair<int, int>>{{3, 5}, {3, 7}}));
  EXPECT_EQ(sorted(convex_corners({{3, 5}})), (std::vector<std::pair<int, int>>{{3, 5}}));
  EXPECT_TRUE(convex_corners({}).empty());
}

}  // namespace
}  // namespace facet
