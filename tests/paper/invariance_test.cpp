#include "paper/invariance.hpp"

#include <gtest/gtest.h>

namespace facet {
namespace {

/// `scenes` frames at a level, each with `detected` of `of` surfaces.
void add_level(std::vector<FrameRow>& rows, double level, int scenes, int detected, int of) {
  for (int i = 0; i < scenes; ++i) {
    FrameRow row;
    row.dataset = "noise";
    row.level = level;
    row.score = FrameScore{};
    row.score->annotated.surfaces = true;
    row.score->surfaces_50.truth = of;
    row.score->surfaces_50.detected = detected;
    rows.push_back(row);
  }
}

TEST(LevelDrop, IsTakenAtTheWorstLevelAgainstTheNominalOne) {
  std::vector<FrameRow> rows;
  add_level(rows, 0, 4, 10, 10);
  add_level(rows, 1, 4, 9, 10);
  add_level(rows, 4, 4, 6, 10);
  const auto drop = level_drop(rows, "noise", 1, 200);
  ASSERT_TRUE(drop);
  EXPECT_EQ(drop->worst_level, 4);
  EXPECT_NEAR(drop->points, -30, 1e-9);
  ASSERT_TRUE(drop->interval);
  EXPECT_NEAR(drop->interval->lo, -30, 1e-9);  // all scenes alike
  EXPECT_FALSE(is_invariant(*drop));
}

TEST(LevelDrop, EqualLevelsAreInvariant) {
  std::vector<FrameRow> rows;
  add_level(rows, 1, 3, 9, 10);
  add_level(rows, 2, 3, 9, 10);
  EXPECT_TRUE(is_invariant(*level_drop(rows, "noise", 1, 200)));
}

TEST(LevelDrop, ADropThatOneSceneMakesHasAnIntervalTooWideToHold) {
  std::vector<FrameRow> rows;
  add_level(rows, 1, 3, 10, 10);
  add_level(rows, 2, 2, 10, 10);
  add_level(rows, 2, 1, 9, 10);
  const auto drop = level_drop(rows, "noise", 1, 500);
  ASSERT_TRUE(drop);
  EXPECT_NEAR(drop->points, -10.0 / 3, 1e-9);
  EXPECT_FALSE(is_invariant(*drop));
}

TEST(LevelDrop, OneLevelOrNoNominalOneMeasuresNothing) {
  std::vector<FrameRow> rows;
  add_level(rows, 1, 3, 9, 10);
  EXPECT_FALSE(level_drop(rows, "noise", 1, 100));
  add_level(rows, 2, 3, 9, 10);
  EXPECT_FALSE(level_drop(rows, "noise", 5, 100));
  EXPECT_FALSE(level_drop(rows, "other", 1, 100));
}

}  // namespace
}  // namespace facet
