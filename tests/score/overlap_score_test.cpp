#include "score/overlap_score.hpp"

#include <gtest/gtest.h>

#include "score/desk.hpp"
#include "score/object_masks.hpp"

namespace facet {
namespace {

RegionComparison compare(const FrameTruth& frame, const Image<std::uint16_t>& labels) {
  Prediction prediction;
  prediction.labels = labels;
  return compare_regions(frame, frame.objects, object_regions(frame, prediction));
}

TEST(OverlapScore, CountsWhatAShiftedRegionSharesWithItsObject) {
  const FrameTruth frame = frame_truth(desk_masks(), {});
  Image<std::uint16_t> labels(frame.size, 0);
  fill_box<std::uint16_t>(labels, 34, 20, 74, 80, 1);  // object 1, 4 px to the right
  const OverlapScore s = score_overlap(compare(frame, labels));
  EXPECT_EQ(s.truth_px, 40 * 60 + 30 * 60);
  EXPECT_EQ(s.predicted_px, 40 * 60);
  EXPECT_EQ(s.common_px, 36 * 60);
  EXPECT_EQ(s.found_75, 1);
  EXPECT_EQ(s.truth, 2);
  EXPECT_EQ(s.boundary_predicted, 2 * (40 + 60) - 4);
  EXPECT_EQ(s.boundary_truth, 2 * (40 + 60) - 4 + 2 * (30 + 60) - 4);
  // Radius 1: rows 20 and 79 near over x 34 ... 70, column 69 is reached by none of the true side, and the
  // column at 34 reaches into the rows of the truth at its ends alone.
  EXPECT_EQ(boundary_radius_px(frame.size), 1);
  EXPECT_EQ(s.boundary_predicted_hit, 2 * (70 - 34 + 1) + 2 /* (34, 21) and (34, 78) */);
}

TEST(OverlapScore, RegionsMostlyOffTheObjectsAreLeftOut) {
  const FrameTruth frame = frame_truth(desk_masks(), {});
  Image<std::uint16_t> labels = desk_masks();
  fill_box<std::uint16_t>(labels, 0, 95, 160, 120, 3);
  const OverlapScore s = score_overlap(compare(frame, labels));
  EXPECT_EQ(s.predicted, 2);
  EXPECT_EQ(s.common_px, s.predicted_px);
  EXPECT_EQ(s.common_px, s.truth_px);
}

TEST(OverlapScore, OutlinePixelsAtVoidDoNotCount) {
  Image<float> depth({160, 120}, 1.0f);
  fill_box(depth, 0, 0, 160, 20, 0.0f);  // above object 1 there is void
  const FrameTruth frame = frame_truth(desk_masks(), depth);
  EXPECT_EQ(frame.objects.outlines[0].size(), 2u * (40 + 60) - 4 - 40);
  EXPECT_EQ(frame.objects.outlines[1].size(), 2u * (30 + 60) - 4);
}

TEST(OverlapScore, LabelsOfOneGroupAreOneRegion) {
  const FrameTruth frame = frame_truth(desk_masks(), {});
  Prediction prediction;
  prediction.labels = desk_masks();
  fill_box<std::uint16_t>(prediction.labels, 30, 20, 70, 40, 7);
  for (const int id : {1, 7}) {
    prediction.surfaces.emplace_back();
    prediction.surfaces.back().id = id;
    prediction.surfaces.back().object = 3;
  }
  const auto grouped = compare_regions(frame, frame.objects, object_regions(frame, prediction));
  EXPECT_EQ(score_overlap(grouped).found_75, 2);
  EXPECT_EQ(score_overlap(grouped).common_px, score_overlap(grouped).truth_px);
  EXPECT_LT(score_overlap(compare(frame, prediction.labels)).common_px, score_overlap(grouped).truth_px);
}

TEST(PrecisionRecall, HasTheEdgeCasesOfTheProtocol) {
  const auto expect = [](PrecisionRecall pr, double p, double r, double f) {
    EXPECT_DOUBLE_EQ(pr.precision, p);
    EXPECT_DOUBLE_EQ(pr.recall, r);
    EXPECT_DOUBLE_EQ(pr.f, f);
  };
  expect(precision_recall(0, 0, 0, 9), 1, 0, 0);  // nothing predicted
  expect(precision_recall(0, 9, 0, 0), 0, 1, 0);  // nothing to find
  expect(precision_recall(0, 0, 0, 0), 1, 1, 1);
  expect(precision_recall(0, 9, 0, 9), 0, 0, 0);
  expect(precision_recall(5, 10, 5, 5), 0.5, 1, 2.0 / 3);
}

TEST(ObjectMasks, PixelsInARegionThatIsMostlyAnotherObjectLeak) {
  const FrameTruth frame = frame_truth(desk_masks(), {});
  Image<std::uint16_t> labels = desk_masks();
  fill_box<std::uint16_t>(labels, 100, 30, 130, 40, 1);  // 300 px of object 2 under the label of object 1
  fill_box<std::uint16_t>(labels, 100, 80, 130, 90, 0);  // 300 px of it under none
  fill_box<std::uint16_t>(labels, 30, 70, 70, 120, 3);   // 400 px of object 1 in a region mostly off it
  const ObjectMaskScore s = score_object_masks(compare(frame, labels));
  EXPECT_EQ(s.leakage, (Tally{300 + 400, 4200}));
  EXPECT_EQ(s.coverage, (Tally{3900, 4200}));
}

TEST(ObjectMasks, OutlinesAreRecalledByRegionsOfWhateverClass) {
  const FrameTruth frame = frame_truth(desk_masks(), {});
  const ObjectMaskScore same = score_object_masks(compare(frame, desk_masks()));
  EXPECT_EQ(same.outline_recall, (Tally{372, 372}));
  EXPECT_EQ(same.outline_precision, (Tally{372, 372}));
  const ObjectMaskScore none = score_object_masks(compare(frame, Image<std::uint16_t>(frame.size, 0)));
  EXPECT_EQ(none.outline_recall, (Tally{0, 372}));
  EXPECT_EQ(none.outline_precision, (Tally{0, 0}));
}

}  // namespace
}  // namespace facet
