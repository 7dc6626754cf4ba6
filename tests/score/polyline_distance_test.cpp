#include "score/polyline_distance.hpp"

#include <gtest/gtest.h>

#include "score/offsets.hpp"
#include "support/awkward_frames.hpp"

namespace facet {
namespace {

TEST(PolylineDistance, SamplesLieAtWholeArcLengthsRoundCorners) {
  const ImagePath samples = sample_line({{0, 0}, {2.5, 0}, {2.5, 1.5}});
  ASSERT_EQ(samples.size(), 5u);
  EXPECT_EQ(samples[2], (ImagePoint{2, 0}));
  EXPECT_NEAR(samples[3].y, 0.5, 1e-12);
  EXPECT_NEAR(samples[4].y, 1.5, 1e-12);
}

TEST(PolylineDistance, RepeatedPointsGiveNoSamplesOfTheirOwn) {
  EXPECT_EQ(sample_line({{1, 1}, {1, 1}, {4, 1}, {4, 1}}).size(), 4u);
}

TEST(PolylineDistance, DrawnDistancesAreThoseToTheWholeLineWithinReach) {
  const ImagePath line{{3.3, 4.1}, {70.2, 9.7}, {75.5, 50.3}, {20.4, 38.8}};
  Image<float> drawn({90, 60}, std::numeric_limits<float>::infinity());
  draw_distance(line, 11, drawn);
  int near = 0;
  for (int y = 0; y < drawn.height(); ++y) {
    for (int x = 0; x < drawn.width(); ++x) {
      const double exact = distance_px({static_cast<double>(x), static_cast<double>(y)}, line);
      if (exact > 11) {
        EXPECT_GT(drawn(x, y), 10.9f);
      } else {
        ASSERT_NEAR(drawn(x, y), exact, 1e-5) << x << "," << y;
        ++near;
      }
    }
  }
  EXPECT_GT(near, 1000);
}

TEST(GridOffsets, AreAllStepsWithinTheRadiusNearestFirst) {
  const auto offsets = offsets_within(5);
  EXPECT_EQ(offsets.size(), 81u);  // lattice points in a circle of radius 5
  EXPECT_EQ(offsets[0].length_px, 0);
  for (std::size_t i = 1; i < offsets.size(); ++i) EXPECT_LE(offsets[i - 1].length_px, offsets[i].length_px);
}

}  // namespace
}  // namespace facet
