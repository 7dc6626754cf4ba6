#include "score/region_match.hpp"

#include <gtest/gtest.h>

#include "score/desk.hpp"
#include "score/surface_detection.hpp"
#include "score/truth_prediction.hpp"
#include "support/expect_error.hpp"

namespace facet {
namespace {

RegionComparison compare(const FrameTruth& frame, const Image<std::uint16_t>& labels) {
  Prediction prediction;
  prediction.labels = labels;
  return compare_regions(frame, frame.surfaces, surface_regions(frame, prediction));
}

DetectionScore detect(const FrameTruth& frame, const Image<std::uint16_t>& labels) {
  const RegionComparison c = compare(frame, labels);
  return score_detection(frame.surfaces, c.matches, c.classes);
}

TEST(RegionMatch, ASurfaceFoundWithHalfItsUnionIsDetectedAndLessIsNot) {
  const FrameTruth frame = frame_truth(desk(), {}, {});
  Image<std::uint16_t> labels(frame.size, 0);
  fill_box<std::uint16_t>(labels, 30, 40, 50, 80, 5);  // 800 of the 1600 px of surface 2: IoU is exactly 0.5
  EXPECT_EQ(detect(frame, labels).detected, 1);
  EXPECT_DOUBLE_EQ(detect(frame, labels).iou_total, 0.5);
  labels(30, 40) = 0;
  EXPECT_EQ(detect(frame, labels).detected, 0);
  EXPECT_EQ(detect(frame, labels).wrong, 1);
}

TEST(RegionMatch, TheLargestUnmatchedRegionOnTheSupportIsTheTableAndTheNextIsFalse) {
  const FrameTruth frame = frame_truth(desk(), {}, {});
  Image<std::uint16_t> labels(frame.size, 0);
  fill_box<std::uint16_t>(labels, 0, 100, 160, 120, 3);
  fill_box<std::uint16_t>(labels, 0, 80, 20, 100, 2);
  const DetectionScore score = detect(frame, labels);
  EXPECT_EQ(score.table, 1);
  EXPECT_EQ(score.wrong, 1);
  EXPECT_EQ(score.precision(), (Tally{0, 1}));
}

TEST(RegionMatch, OfEquallyLargeRegionsOnTheSupportTheLowestIdIsTheTable) {
  const FrameTruth frame = frame_truth(desk(), {}, {});
  Image<std::uint16_t> labels(frame.size, 0);
  fill_box<std::uint16_t>(labels, 0, 100, 20, 120, 9);
  fill_box<std::uint16_t>(labels, 40, 100, 60, 120, 4);
  const RegionComparison c = compare(frame, labels);
  EXPECT_EQ(c.predicted.regions[0].ids[0], 4);
  EXPECT_EQ(c.classes[0], RegionClass::table);
  EXPECT_EQ(c.classes[1], RegionClass::wrong);
}

TEST(RegionMatch, SupportWithoutDepthHasNoTable) {
  const FrameTruth frame = frame_truth(desk(), {}, Image<float>({160, 120}, 0.0f));
  Image<std::uint16_t> labels(frame.size, 0);
  fill_box<std::uint16_t>(labels, 0, 100, 160, 120, 3);
  EXPECT_EQ(detect(frame, labels).table, 0);
  EXPECT_EQ(detect(frame, labels).wrong, 1);
}

TEST(RegionMatch, RegionsOnTheWallInVoidOrTooSmallAreReportedAndNotFalse) {
  Truth truth = desk();
  truth.ignore.push_back({rectangle(140, 0, 160, 120), 0});
  const FrameTruth frame = frame_truth(truth, {}, {});
  Image<std::uint16_t> labels(frame.size, 0);
  fill_box<std::uint16_t>(labels, 0, 0, 100, 10, 1);     // wall
  fill_box<std::uint16_t>(labels, 138, 30, 150, 80, 2);  // mostly void
  fill_box<std::uint16_t>(labels, 2, 50, 11, 61, 3);     // 99 px
  fill_box<std::uint16_t>(labels, 35, 45, 45, 55, 4);    // 100 px on a surface
  const DetectionScore score = detect(frame, labels);
  EXPECT_EQ(score.background, 1);
  EXPECT_EQ(score.ignored, 1);
  EXPECT_EQ(score.tiny, 1);
  EXPECT_EQ(score.wrong, 1);
}

TEST(RegionMatch, TwoPartsOfAFaceThatAnOccluderCutsAreOneRegion) {
  Truth truth = desk();
  truth.surfaces.push_back({.number = 4, .object = 3, .parts = {{rectangle(30, 50, 70, 60), -1}}});
  const FrameTruth frame = frame_truth(truth, {}, {});
  ASSERT_EQ(frame.surface_parts.parts.size(), 5u);
  Image<std::uint16_t> labels(frame.size, 0);
  fill_box<std::uint16_t>(labels, 30, 40, 70, 50, 7);
  fill_box<std::uint16_t>(labels, 30, 60, 70, 80, 6);
  const RegionComparison c = compare(frame, labels);
  ASSERT_EQ(c.predicted.regions.size(), 1u);
  EXPECT_EQ(c.predicted.regions[0].ids, (std::vector<int>{6, 7}));
  ASSERT_EQ(c.matches.size(), 1u);
  EXPECT_DOUBLE_EQ(c.matches[0].iou, 1.0);
}

TEST(RegionMatch, TwoHalvesOfAWholeFaceStayTwoRegions) {
  const FrameTruth frame = frame_truth(desk(), {}, {});
  Image<std::uint16_t> labels(frame.size, 0);
  fill_box<std::uint16_t>(labels, 30, 40, 70, 65, 1);
  fill_box<std::uint16_t>(labels, 30, 65, 70, 80, 2);
  const DetectionScore score = detect(frame, labels);
  EXPECT_EQ(score.detected, 1);
  EXPECT_EQ(score.wrong, 1);
}

TEST(RegionMatch, NamesOfLabelsDoNotMatter) {
  const FrameTruth frame = frame_truth(desk(), {}, {});
  Image<std::uint16_t> labels = truth_as_prediction(frame).labels;
  const DetectionScore before = detect(frame, labels);
  for (int y = 0; y < labels.height(); ++y)
    for (int x = 0; x < labels.width(); ++x)
      if (labels(x, y) != 0) labels(x, y) = static_cast<std::uint16_t>(65535 - 7 * labels(x, y));
  const DetectionScore after = detect(frame, labels);
  EXPECT_EQ(before.detected, 3);
  EXPECT_EQ(after.detected, 3);
  EXPECT_DOUBLE_EQ(before.iou_total, after.iou_total);
}

TEST(RegionMatch, LabelsOfAnotherSizeAreADataErrorThatNamesBothSizes) {
  const FrameTruth frame = frame_truth(desk(), {}, {});
  Prediction prediction;
  prediction.labels = Image<std::uint16_t>({80, 60}, 0);
  expect_error(ErrorKind::data, "80x60 px, the truth 160x120 px",
               [&] { surface_regions(frame, prediction); });
  prediction.labels = Image<std::uint16_t>(frame.size, 0);
  prediction.edges = Image<std::uint8_t>({160, 121}, 0);
  expect_error(ErrorKind::data, "predicted edges are 160x121", [&] { surface_regions(frame, prediction); });
}

TEST(FrameTruth, OfMasksAloneIgnoresMissingDepthOffTheObjectsAndTinyObjects) {
  Image<std::uint16_t> masks = desk_masks();
  fill_box<std::uint16_t>(masks, 0, 0, 5, 5, 40);
  Image<float> depth({160, 120}, 1.0f);
  depth(150, 100) = depth(50, 50) = 0;
  const FrameTruth frame = frame_truth(masks, depth);
  EXPECT_EQ(frame.object_values, (std::vector<int>{1, 2}));
  EXPECT_EQ(frame.objects.regions(150, 100), TruthRegion::ignored);
  EXPECT_EQ(frame.objects.regions(2, 2), TruthRegion::ignored);
  EXPECT_EQ(frame.objects.map(50, 50), 1);
  EXPECT_FALSE(frame.has_surfaces);
}

}  // namespace
}  // namespace facet
