#include "edge_pairs/segments.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "core/image.hpp"

namespace facet {
namespace {

class Segments : public ::testing::Test {
 protected:
  void line(int x0, int y0, int x1, int y1) {
    const int steps = std::max(std::abs(x1 - x0), std::abs(y1 - y0));
    for (int i = 0; i <= steps; ++i) edges_(x0 + (x1 - x0) * i / steps, y0 + (y1 - y0) * i / steps) = 1;
  }
  std::vector<Segment> find() const { return find_segments(params_, edges_.view()); }

  EdgePairParams params_;
  Image<std::uint8_t> edges_{Size{100, 80}, 0};
};

TEST_F(Segments, ACornerIsSplitAndEachSideKeepsItsPixels) {
  line(10, 10, 60, 10);
  line(60, 10, 60, 50);
  const auto segments = find();
  ASSERT_EQ(segments.size(), 2u);
  for (const Segment& s : segments) {
    EXPECT_TRUE(std::abs(s.from.x - s.to.x) < 3 || std::abs(s.from.y - s.to.y) < 3);
    EXPECT_GE(s.pixels.size(), 38u);
  }
}

TEST_F(Segments, AGapInALineIsBridgedAndAWideOneIsNot) {
  line(10, 20, 40, 20);
  line(46, 20, 80, 20);
  ASSERT_EQ(find().size(), 1u);
  EXPECT_NEAR(norm(find()[0].to - find()[0].from), 70, 1);
  for (int x = 41; x < 52; ++x) edges_(x, 20) = 0;
  EXPECT_EQ(find().size(), 2u);
}

TEST_F(Segments, ParallelLinesStayApartAndShortOnesAreDropped) {
  line(10, 20, 80, 20);
  line(10, 24, 80, 24);
  line(10, 60, 20, 60);
  EXPECT_EQ(find().size(), 2u);
}

TEST_F(Segments, ASquareHasFourSidesAndAJunctionEndsALine) {
  line(20, 20, 60, 20);
  line(60, 20, 60, 60);
  line(60, 60, 20, 60);
  line(20, 60, 20, 20);
  EXPECT_EQ(find().size(), 4u);
  line(60, 40, 90, 40);
  EXPECT_EQ(find().size(), 5u);  // the side that it meets goes on in one line
}

TEST_F(Segments, NoEdgesGiveNone) {
  EXPECT_TRUE(find().empty());
  edges_(3, 3) = 1;
  EXPECT_TRUE(find().empty());
}

}  // namespace
}  // namespace facet
