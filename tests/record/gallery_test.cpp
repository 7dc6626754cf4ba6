#include "record/gallery.hpp"

#include <gtest/gtest.h>

#include "support/expect_error.hpp"

namespace facet {
namespace {

FrameRow row_with(const std::string& frame, const std::string& method, int detected, int of) {
  FrameRow row;
  row.dataset = "d";
  row.frame = frame;
  row.method = method;
  row.pictures = {"overlays/" + frame + ".png"};
  row.score = FrameScore{};
  row.score->annotated.surfaces = true;
  row.score->surfaces_50.truth = of;
  row.score->surfaces_50.detected = detected;
  return row;
}

TEST(WorstFrames, AreTheLowestOfEveryMethodWorstFirst) {
  const std::vector<FrameRow> rows{row_with("a", "m", 3, 4), row_with("b", "m", 1, 4),
                                   row_with("c", "m", 2, 4), row_with("a", "n", 4, 4)};
  const auto worst = worst_frames(rows, "surface_recall_0.5", 2);
  ASSERT_EQ(worst.size(), 3u);
  EXPECT_EQ(worst[0].frame, "b");
  EXPECT_EQ(*worst[0].value, 0.25);
  EXPECT_EQ(worst[0].picture, "overlays/b.png");
  EXPECT_EQ(worst[1].frame, "c");
  EXPECT_EQ(worst[2].method, "n");
}

TEST(DisputedFrames, AreThoseWithTheLargestSpreadAndNameTheBestMethod) {
  const std::vector<FrameRow> rows{row_with("a", "m", 3, 4), row_with("a", "n", 2, 4),
                                   row_with("b", "m", 0, 4), row_with("b", "n", 4, 4),
                                   row_with("c", "m", 1, 4), row_with("c", "n", 1, 4)};
  const auto disputed = disputed_frames(rows, "surface_recall_0.5", 5);
  ASSERT_EQ(disputed.size(), 2u);
  EXPECT_EQ(disputed[0].frame, "b");
  EXPECT_EQ(disputed[0].method, "n");
  EXPECT_EQ(*disputed[0].value, 1);
  EXPECT_EQ(*disputed[0].baseline, 0);
  EXPECT_EQ(disputed[1].frame, "a");
  EXPECT_EQ(disputed[1].method, "m");
  EXPECT_EQ(disputed_frames(rows, "surface_recall_0.5", 1).size(), 1u);
}

TEST(WorstFrames, AFrameWithoutTruthIsInNoGallery) {
  FrameRow row = row_with("a", "m", 1, 1);
  row.score.reset();
  EXPECT_TRUE(worst_frames({row}, "surface_recall_0.5", 5).empty());
}

TEST(WorstFrames, AgainstAnotherRunTheLargestLossComesFirst) {
  const std::vector<FrameRow> now{row_with("a", "m", 1, 4), row_with("b", "m", 3, 4),
                                  row_with("c", "m", 0, 4)};
  const std::vector<FrameRow> before{row_with("a", "m", 1, 4), row_with("b", "m", 4, 4)};
  const auto worst = worst_frames(now, before, "surface_recall_0.5", 5);
  ASSERT_EQ(worst.size(), 2u);
  EXPECT_EQ(worst[0].frame, "b");
  EXPECT_EQ(*worst[0].baseline, 1);
}

TEST(WorstFrames, AnUnknownMetricIsAnErrorThatNamesTheKnownOnes) {
  expect_error(ErrorKind::usage, "surface_recall_0.5", [] { worst_frames({}, "nope", 1); });
}

TEST(Gallery, ReadsBack) {
  const auto entries = worst_frames({row_with("a \"b\"", "m", 1, 4)}, "surface_recall_0.5", 1);
  const auto read = gallery_from_json(to_json(entries));
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(to_json(read), to_json(entries));
  expect_error(ErrorKind::data, "no gallery", [] { gallery_from_json("{}"); });
}

}  // namespace
}  // namespace facet
