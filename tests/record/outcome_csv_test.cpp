#include "record/outcome_csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "record/csv.hpp"

namespace facet {
namespace {

using ::testing::ElementsAre;

FrameRow scored_row() {
  FrameRow row;
  row.dataset = "set";
  row.frame = "frame";
  row.method = "method";
  row.score = FrameScore{};
  row.score->surfaces = {{1, 7, 500, true, false, 3, 0.75}, {2, 7, 100, false, true, 0, 0}};
  row.score->edges.outcomes = {{4, 7, EdgeKind::convex, true, 40, 30, 20, false}};
  return row;
}

TEST(SurfacesCsv, HasALinePerSurfaceAndLeavesOpenWhatWasNotFound) {
  const auto rows = parse_csv(surfaces_csv({scored_row()}));
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_THAT(rows[1], ElementsAre("set", "frame", "method", "1", "7", "500", "1", "0", "3", "0.7500"));
  EXPECT_THAT(rows[2], ElementsAre("set", "frame", "method", "2", "7", "100", "0", "1", "", ""));
}

TEST(EdgesCsv, HasALinePerEdge) {
  const auto rows = parse_csv(edges_csv({scored_row()}));
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_THAT(rows[1], ElementsAre("set", "frame", "method", "4", "7", "convex", "1", "40", "30", "20", "0"));
}

TEST(OutcomeCsv, AFrameWithoutTruthHasNoLines) {
  FrameRow row = scored_row();
  row.score.reset();
  EXPECT_EQ(parse_csv(surfaces_csv({row})).size(), 1u);
  EXPECT_EQ(parse_csv(edges_csv({row})).size(), 1u);
}

TEST(OutcomeCsv, OutcomesReadBackFromTheRowsOfARun) {
  const FrameRow read = frame_row_from_json(to_json_line(scored_row()));
  EXPECT_EQ(surfaces_csv({read}), surfaces_csv({scored_row()}));
  EXPECT_EQ(edges_csv({read}), edges_csv({scored_row()}));
}

}  // namespace
}  // namespace facet
