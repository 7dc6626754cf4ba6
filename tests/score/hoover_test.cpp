#include "score/hoover.hpp"

#include <gtest/gtest.h>

#include "support/awkward_frames.hpp"

namespace facet {
namespace {

/// Drawn label images of 8x8 pixels, '.' = none; every region is compared.
HooverCounts count(const std::vector<std::string>& truth_rows, const std::vector<std::string>& region_rows,
                   double tolerance = 0.8) {
  const auto drawn = [](const std::vector<std::string>& rows) {
    return make_image<std::uint16_t>({8, 8}, [&](int x, int y) {
      const char c = rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
      return c == '.' ? 0 : c - 'a' + 1;
    });
  };
  TruthLabels truth{.map = drawn(truth_rows), .area_px = std::vector<int>(26, 0)};
  PredictedRegions predicted{drawn(region_rows), std::vector<PredictedRegion>(26)};
  int truth_count = 0, region_count = 0;
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      const int t = truth.map(x, y), r = predicted.map(x, y);
      truth_count = std::max(truth_count, t), region_count = std::max(region_count, r);
      if (t > 0) ++truth.area_px[static_cast<std::size_t>(t - 1)];
      if (r > 0) ++predicted.regions[static_cast<std::size_t>(r - 1)].area_px;
    }
  }
  truth.area_px.resize(static_cast<std::size_t>(truth_count));
  predicted.regions.resize(static_cast<std::size_t>(region_count));
  std::vector<RegionClass> classes(predicted.regions.size(), RegionClass::wrong);
  const auto overlaps = count_overlaps(truth.map, predicted.map);
  return hoover_counts({truth, predicted, overlaps, {}, classes, {}}, tolerance);
}

const std::vector<std::string> two_halves{"aaaabbbb", "aaaabbbb", "aaaabbbb", "aaaabbbb",
                                          "aaaabbbb", "aaaabbbb", "aaaabbbb", "aaaabbbb"};
const std::vector<std::string> one(8, "aaaaaaaa"), nothing(8, "........");

TEST(Hoover, TheTruthItselfIsCorrect) {
  const HooverCounts c = count(two_halves, two_halves, 1.0);
  EXPECT_EQ(c, (HooverCounts{.truth = 2, .predicted = 2, .correct = 2}));
}

TEST(Hoover, ASurfaceInTwoPiecesIsOverSegmented) {
  const HooverCounts c = count(one, two_halves);
  EXPECT_EQ(c, (HooverCounts{.truth = 1, .predicted = 2, .over = 1, .over_regions = 2}));
}

TEST(Hoover, TwoSurfacesInOneRegionAreUnderSegmented) {
  const HooverCounts c = count(two_halves, one);
  EXPECT_EQ(c, (HooverCounts{.truth = 2, .predicted = 1, .under = 1, .under_truth = 2}));
}

TEST(Hoover, NothingFoundIsMissedAndARegionOnNothingIsNoise) {
  EXPECT_EQ(count(two_halves, nothing), (HooverCounts{.truth = 2, .missed = 2}));
  EXPECT_EQ(count(nothing, two_halves), (HooverCounts{.predicted = 2, .noise = 2}));
}

TEST(Hoover, CorrectNeedsTheToleranceOfBothAreas) {
  // Surface of 40 px, region of 32 px within it: 32 / 40 is exactly 0.8.
  const std::vector<std::string> five_rows{"aaaaaaaa", "aaaaaaaa", "aaaaaaaa", "aaaaaaaa",
                                           "aaaaaaaa", "........", "........", "........"};
  std::vector<std::string> four_rows = five_rows;
  four_rows[4] = "........";
  EXPECT_EQ(count(five_rows, four_rows).correct, 1);
  EXPECT_EQ(count(five_rows, four_rows, 0.81).missed, 1);
  EXPECT_EQ(count(four_rows, five_rows).correct, 1);
}

TEST(Hoover, OfTwoInstancesTheOneWithTheHigherMeanCounts) {
  // Region a has 36 of 64 px, b the other 28. At 0.55 the surface is correct with a (mean 0.78) and
  // over-segmented by both (mean 1): the latter counts.
  const std::vector<std::string> parts{"aaaaaaaa", "aaaaaaaa", "aaaaaaaa", "aaaaaaaa",
                                       "aaaabbbb", "bbbbbbbb", "bbbbbbbb", "bbbbbbbb"};
  EXPECT_EQ(count(one, parts, 0.55),
            (HooverCounts{.truth = 1, .predicted = 2, .over = 1, .over_regions = 2}));
}

TEST(Hoover, AFragmentThatCompletesASurfaceMakesItOverSegmented) {
  // Correct with region a alone has the mean (1 + 56/64) / 2, both regions together have 1.
  const std::vector<std::string> parts{"aaaaaaaa", "aaaaaaaa", "aaaaaaaa", "aaaaaaaa",
                                       "aaaaaaaa", "aaaaaaaa", "aaaaaaaa", "bbbbbbbb"};
  EXPECT_EQ(count(one, parts).over, 1);
  EXPECT_EQ(count(one, parts).correct, 0);
}

}  // namespace
}  // namespace facet
