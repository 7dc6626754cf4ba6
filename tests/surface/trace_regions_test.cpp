#include <gtest/gtest.h>
#include <set>
#include <utility>

#include "core/random.hpp"
#include "surface/label_map.hpp"

namespace facet {
namespace {

using Pixels = std::set<std::pair<int, int>>;

std::vector<Surface> traced(const Image<std::uint16_t>& labels) {
  const std::vector<PixelBox> boxes = boxes_of(labels);
  std::vector<Surface> surfaces = numbered_surfaces(boxes.size());
  trace_regions(labels.view(), boxes, surfaces);
  return surfaces;
}

Pixels outline_pixels(const Surface& surface) {
  Pixels pixels;
  for (const ContourPoint& p : surface.contour.outer) pixels.emplace(p.x, p.y);
  for (const Polyline& hole : surface.contour.holes)
    for (const ContourPoint& p : hole) pixels.emplace(p.x, p.y);
  return pixels;
}

/// Pixels of the label with a side towards another label, no label, or the outside of the image.
Pixels border_pixels(const Image<std::uint16_t>& labels, int label) {
  Pixels pixels;
  const auto is = [&](int x, int y) { return labels.size().contains(x, y) && labels(x, y) == label; };
  for (int y = 0; y < labels.height(); ++y)
    for (int x = 0; x < labels.width(); ++x)
      if (is(x, y) && !(is(x - 1, y) && is(x + 1, y) && is(x, y - 1) && is(x, y + 1))) pixels.emplace(x, y);
  return pixels;
}

void flood(const Image<int>& colour, int x, int y, std::uint16_t label, Image<std::uint16_t>& labels) {
  std::vector<std::pair<int, int>> open{{x, y}};
  while (!open.empty()) {
    const auto [px, py] = open.back();
    open.pop_back();
    if (!colour.size().contains(px, py) || labels(px, py) != 0 || colour(px, py) != colour(x, y)) continue;
    labels(px, py) = label;
    for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
      open.emplace_back(px + dx, py + dy);
  }
}

/// The 4-connected parts of random overlapping rectangles; rectangles of colour 0 stay without label.
Image<std::uint16_t> random_regions(Size size, std::uint64_t seed) {
  Image<int> colour(size, 1);
  std::uint64_t draw = 0;
  const auto below = [&](int n) {
    return static_cast<int>(random_below(static_cast<std::uint32_t>(n), seed, 0, draw++));
  };
  for (int i = 0; i < 24; ++i) {
    const int x0 = below(size.width), y0 = below(size.height), c = below(5);
    const int x1 = std::min(size.width, x0 + 1 + below(size.width)),
              y1 = std::min(size.height, y0 + 1 + below(9));
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x) colour(x, y) = c;
  }
  Image<std::uint16_t> labels(size, 0);
  std::uint16_t count = 0;
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      if (colour(x, y) != 0 && labels(x, y) == 0) flood(colour, x, y, ++count, labels);
  return labels;
}

TEST(TraceRegions, OutlinesAreExactlyTheBorderPixelsOfEachLabel) {
  for (const Size size : {Size{1, 1}, Size{31, 7}, Size{33, 9}, Size{64, 48}})
    for (std::uint64_t seed = 0; seed < 25; ++seed) {
      const Image<std::uint16_t> labels = random_regions(size, seed);
      for (const Surface& surface : traced(labels))
        ASSERT_EQ(outline_pixels(surface), border_pixels(labels, surface.id))
            << size.width << "x" << size.height << ", seed " << seed << ", label " << surface.id;
    }
}

TEST(TraceRegions, ARingHasOneOuterOutlineAndOneHole) {
  const std::vector<Surface> surfaces = traced(label_map({".......",  //
                                                          ".11111.",  //
                                                          ".1...1.",  //
                                                          ".1...1.",  //
                                                          ".11111.",  //
                                                          "......."}));
  ASSERT_EQ(surfaces.size(), 1u);
  EXPECT_EQ(surfaces[0].contour.outer.size(), 14u);
  ASSERT_EQ(surfaces[0].contour.holes.size(), 1u);
  EXPECT_EQ(surfaces[0].parent, 0);
}

TEST(TraceRegions, TouchingRegionsEachHaveAnOutlineOfTheirOwn) {
  const std::vector<Surface> surfaces = traced(label_map({"111222",  //
                                                          "111222",  //
                                                          "111222"}));
  ASSERT_EQ(surfaces.size(), 2u);
  EXPECT_EQ(surfaces[0].contour.outer.size(), 8u);
  EXPECT_EQ(surfaces[1].contour.outer.size(), 8u);
  EXPECT_EQ(surfaces[0].parent, 0);
  EXPECT_EQ(surfaces[1].parent, 0);
}

TEST(TraceRegions, ASinglePixelIsItsOwnOutline) {
  const std::vector<Surface> surfaces = traced(label_map({"1"}));
  ASSERT_EQ(surfaces[0].contour.outer, (Polyline{{0, 0}}));
  EXPECT_TRUE(surfaces[0].contour.holes.empty());
}

TEST(TraceRegions, ASurfaceIsTheChildOfTheSmallestHoleAroundIt) {
  const std::vector<Surface> surfaces = traced(label_map({"11111111111",  //
                                                          "1.........1",  //
                                                          "1.2222222.1",  //
                                                          "1.2.....2.1",  //
                                                          "1.2.3.4.2.1",  //
                                                          "1.2.....2.1",  //
                                                          "1.2222222.1",  //
                                                          "1.........1",  //
                                                          "11111111111"}));
  ASSERT_EQ(surfaces.size(), 4u);
  EXPECT_EQ(surfaces[0].parent, 0);
  EXPECT_EQ(surfaces[1].parent, 1);
  EXPECT_EQ(surfaces[2].parent, 2);
  EXPECT_EQ(surfaces[3].parent, 2);
  EXPECT_EQ(surfaces[0].children, (std::vector<int>{2}));
  EXPECT_EQ(surfaces[1].children, (std::vector<int>{3, 4}));
}

TEST(TraceRegions, SurfacesThatFillAHoleTogetherAreAllItsChildren) {
  const std::vector<Surface> surfaces = traced(label_map({"111111",  //
                                                          "122331",  //
                                                          "122331",  //
                                                          "144441",  //
                                                          "111111"}));
  for (int i = 1; i < 4; ++i) EXPECT_EQ(surfaces[static_cast<std::size_t>(i)].parent, 1) << "label " << i + 1;
  EXPECT_EQ(surfaces[0].children, (std::vector<int>{2, 3, 4}));
}

TEST(TraceRegions, AHoleThatIsClosedOnlyAtACornerIsAHole) {
  const std::vector<Surface> surfaces = traced(label_map({"..111",  //
                                                          ".1221",  //
                                                          "11221",  //
                                                          "1.111",  //
                                                          "111.."}));
  EXPECT_EQ(surfaces[1].parent, 1);
}

TEST(TraceRegions, ABayIsNoHole) {
  const std::vector<Surface> surfaces = traced(label_map({"11111",  //
                                                          "1...1",  //
                                                          "1.2.1",  //
                                                          "1...1",  //
                                                          "11.11"}));
  EXPECT_EQ(surfaces[1].parent, 0);
  EXPECT_TRUE(surfaces[0].contour.holes.empty());
  EXPECT_TRUE(surfaces[0].children.empty());
}

}  // namespace
}  // namespace facet
