#include "truth/polygon_fill.hpp"

#include <gtest/gtest.h>
#include <vector>

#include "core/random.hpp"

namespace facet {
namespace {

std::vector<int> filled(const ImagePath& polygon, Size size) {
  std::vector<int> out(static_cast<std::size_t>(size.area()));
  for_each_span(polygon, size, [&](int y, int x0, int x1) {
    for (int x = x0; x < x1; ++x) ++out[static_cast<std::size_t>(y * size.width + x)];
  });
  return out;
}

/// Even-odd by counting crossings of the ray from the pixel to the right.
bool inside_by_ray(const ImagePath& p, double x, double y) {
  bool inside = false;
  for (std::size_t i = 0, j = p.size() - 1; i < p.size(); j = i++) {
    if ((p[i].y > y) == (p[j].y > y)) continue;
    inside ^= x < (p[j].x - p[i].x) * (y - p[i].y) / (p[j].y - p[i].y) + p[i].x;
  }
  return inside;
}

TEST(PolygonFill, LeftAndTopBordersAreInsideRightAndBottomOnesOutside) {
  const auto pixels = filled({{1, 1}, {3, 1}, {3, 2}, {1, 2}}, {5, 4});
  std::vector<int> expected(20);
  expected[5 + 1] = expected[5 + 2] = 1;
  EXPECT_EQ(pixels, expected);
}

TEST(PolygonFill, NeighboursThatShareASideShareNoPixelAndLeaveNoGap) {
  const ImagePoint apex{7.3, 2.1}, foot{5.9, 17.2};
  const auto left = filled({{0, 0}, apex, foot, {0, 19}}, {20, 20});
  const auto right = filled({apex, {19, 0}, {19, 19}, foot}, {20, 20});
  const auto both = filled({{0, 0}, apex, {19, 0}, {19, 19}, foot, {0, 19}}, {20, 20});
  for (std::size_t k = 0; k < both.size(); ++k) EXPECT_EQ(left[k] + right[k], both[k]) << k;
}

TEST(PolygonFill, RandomPolygonsEqualTheCrossingCountOfEveryPixel) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    ImagePath polygon;
    for (std::uint64_t k = 0; k < 3 + seed % 9; ++k) {
      polygon.push_back({random_uniform(seed, 0, k) * 40 - 4.0, random_uniform(seed, 1, k) * 30 - 4.0});
    }
    const auto pixels = filled(polygon, {33, 23});
    for (int y = 0; y < 23; ++y) {
      for (int x = 0; x < 33; ++x) {
        ASSERT_EQ(pixels[static_cast<std::size_t>(y * 33 + x)], inside_by_ray(polygon, x, y)) << seed;
      }
    }
  }
}

TEST(PolygonFill, ASlitOfZeroWidthHoldsNoPixel) {
  // A square ring cut open at y = 4.5 from x = 0 to x = 3.
  const auto pixels = filled({{0, 4.5},
                              {0, -0.5},
                              {9, -0.5},
                              {9, 9},
                              {0, 9},
                              {0, 4.5},
                              {3, 4.5},
                              {3, 6},
                              {6, 6},
                              {6, 3},
                              {3, 3},
                              {3, 4.5}},
                             {10, 10});
  int count = 0;
  for (const int p : pixels) count += p;
  EXPECT_EQ(count, 81 - 9);
}

TEST(PolygonFill, EmptyAndFlatPolygonsHoldNothing) {
  for (const int p : filled({}, {4, 4})) EXPECT_EQ(p, 0);
  for (const int p : filled({{0, 1}, {3, 1}, {2, 1}}, {4, 4})) EXPECT_EQ(p, 0);
}

}  // namespace
}  // namespace facet
