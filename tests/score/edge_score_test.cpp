#include "score/edge_score.hpp"

#include <gtest/gtest.h>

#include "score/desk.hpp"
#include "score/truth_prediction.hpp"
#include "support/expect_error.hpp"

namespace facet {
namespace {

/// One horizontal truth edge of 100 px at y = 200 over a surface, in a VGA frame: the tolerance is 6 px.
Truth one_edge(EdgeKind kind = EdgeKind::depth, double y = 200) {
  Truth truth{.size = {640, 480}};
  truth.surfaces.push_back(
      {.number = 1, .object = 1, .graspable = true, .parts = {{rectangle(100, 200, 200, 300), 0}}});
  truth.edges.push_back({1, 1, kind, kind != EdgeKind::concave, {{100, y}, {199, y}}});
  return truth;
}

Image<std::uint8_t> row_of_edge(int y, int x0, int x1, std::uint8_t code) {
  Image<std::uint8_t> codes({640, 480}, 0);
  fill_box(codes, x0, y, x1, y + 1, code);
  return codes;
}

constexpr std::uint8_t graspable_depth = edge_code(EdgeKind::depth, true);

TEST(EdgeScore, ADistanceOfExactlyTheToleranceIsWithinIt) {
  const FrameTruth frame = frame_truth(one_edge(), {}, {});
  EXPECT_EQ(score_edges(frame, row_of_edge(194, 100, 200, graspable_depth)).recall_6px.all, (Tally{1, 1}));
  EXPECT_EQ(score_edges(frame, row_of_edge(193, 100, 200, graspable_depth)).recall_6px.all, (Tally{0, 1}));
  EXPECT_EQ(score_edges(frame, row_of_edge(197, 100, 200, graspable_depth)).recall_3px.all, (Tally{1, 1}));
  EXPECT_EQ(score_edges(frame, row_of_edge(196, 100, 200, graspable_depth)).recall_3px.all, (Tally{0, 1}));
}

TEST(EdgeScore, DistancesAreTakenFromTheRealPositionOfASample) {
  const FrameTruth frame = frame_truth(one_edge(EdgeKind::depth, 200.4), {}, {});
  EXPECT_EQ(score_edges(frame, row_of_edge(206, 100, 200, graspable_depth)).recall_6px.all.hit, 1);  // 5.6 px
  EXPECT_EQ(score_edges(frame, row_of_edge(194, 100, 200, graspable_depth)).recall_6px.all.hit, 0);  // 6.4 px
}

TEST(EdgeScore, SeventyOfAHundredSamplesMakeAnEdge) {
  const FrameTruth frame = frame_truth(one_edge(), {}, {});
  const auto at_1_px = [&](int length) {
    return score_edges(frame, row_of_edge(200, 100, 100 + length, graspable_depth)).recall_curve[0].all.hit;
  };
  EXPECT_EQ(at_1_px(69), 1);  // the sample after the last pixel is 1 px away
  EXPECT_EQ(at_1_px(68), 0);
}

TEST(EdgeScore, AWrongKindOrLabelIsNoDetectionButALocation) {
  const FrameTruth frame = frame_truth(one_edge(), {}, {});
  for (const std::uint8_t code : {edge_code(EdgeKind::depth, false), edge_code(EdgeKind::convex, true)}) {
    const EdgeScore s = score_edges(frame, row_of_edge(200, 100, 200, code));
    EXPECT_EQ(s.recall_6px.graspable, (Tally{0, 1}));
    EXPECT_EQ(s.recall_kind_ignored_6px.graspable, (Tally{1, 1}));
  }
  EXPECT_EQ(
      score_edges(frame, row_of_edge(200, 100, 200, edge_code(EdgeKind::convex, true))).precision_6px.convex,
      (Tally{0, 100}));
}

TEST(EdgeScore, TheLabelOfAnyOfTheNearestPixelsWillDo) {
  const FrameTruth frame = frame_truth(one_edge(), {}, {});
  Image<std::uint8_t> codes = row_of_edge(202, 100, 200, edge_code(EdgeKind::depth, false));
  fill_box(codes, 100, 198, 200, 199, graspable_depth);  // as near, on the other side
  EXPECT_EQ(score_edges(frame, codes).recall_6px.all.hit, 1);
  fill_box(codes, 100, 201, 200, 202, edge_code(EdgeKind::depth, false));  // nearer
  EXPECT_EQ(score_edges(frame, codes).recall_6px.all.hit, 0);
}

TEST(EdgeScore, EdgesUnderTwelvePixelsDoNotCountButMakePixelsRight) {
  Truth truth = one_edge();
  truth.edges[0].line = {{100, 200}, {111.9, 200}};
  const FrameTruth frame = frame_truth(truth, {}, {});
  const EdgeScore s = score_edges(frame, row_of_edge(200, 100, 112, graspable_depth));
  EXPECT_EQ(s.recall_6px.all, (Tally{0, 0}));
  EXPECT_EQ(s.precision_6px.all, (Tally{12, 12}));
}

TEST(EdgeScore, PixelsFarFromObjectsAndInVoidDoNotCountForPrecision) {
  Truth truth = one_edge();
  truth.ignore.push_back({rectangle(100, 250, 200, 300), 1});
  const FrameTruth frame = frame_truth(truth, {}, {});
  EXPECT_EQ(score_edges(frame, row_of_edge(180, 100, 200, graspable_depth)).precision_6px.all,
            (Tally{0, 100}));
  EXPECT_EQ(score_edges(frame, row_of_edge(179, 100, 200, graspable_depth)).precision_6px.all, (Tally{0, 0}));
  EXPECT_EQ(score_edges(frame, row_of_edge(270, 100, 200, graspable_depth)).precision_6px.all, (Tally{0, 0}));
  truth.edges.push_back({2, 1, EdgeKind::depth, true, {{100, 270}, {199, 270}}});
  EXPECT_EQ(
      score_edges(frame_truth(truth, {}, {}), row_of_edge(270, 100, 200, graspable_depth)).precision_6px.all,
      (Tally{100, 100}));
}

TEST(EdgeScore, ParallelStripesHitEveryEdgeAndAreMostlyWrong) {
  const FrameTruth frame = frame_truth(one_edge(), {}, {});
  Image<std::uint8_t> codes(frame.size, 0);
  for (int y = 0; y < 480; y += 4) fill_box(codes, 0, y, 640, y + 1, graspable_depth);
  const EdgeScore s = score_edges(frame, codes);
  EXPECT_EQ(s.recall_6px.all, (Tally{1, 1}));
  EXPECT_LT(s.precision_6px.all.hit, 0.2 * s.precision_6px.all.n);
}

TEST(EdgeScore, AnUnknownCodeIsADataError) {
  const FrameTruth frame = frame_truth(one_edge(), {}, {});
  expect_error(ErrorKind::data, "unknown code 4", [&] { score_edges(frame, row_of_edge(200, 0, 9, 4)); });
  expect_error(ErrorKind::data, "unknown code 16", [&] { score_edges(frame, row_of_edge(200, 0, 9, 16)); });
}

TEST(EdgeScore, CountsTheDeskByKind) {
  const FrameTruth frame = frame_truth(desk(), desk_masks(), {});
  const EdgeScore s = score_edges(frame, truth_as_prediction(frame).edges);
  EXPECT_EQ(s.recall_3px.graspable, (Tally{7, 7}));
  EXPECT_EQ(s.recall_3px.depth, (Tally{6, 6}));
  EXPECT_EQ(s.recall_3px.convex, (Tally{1, 1}));
  EXPECT_EQ(s.recall_3px.concave, (Tally{2, 2}));
}

}  // namespace
}  // namespace facet
