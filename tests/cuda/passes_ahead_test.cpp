#include "cuda/passes_ahead.hpp"

#include <gtest/gtest.h>
#include <vector>

namespace facet {
namespace {

/// Passes of a stage that changes something in the first `changing` of them; answers lie in slots until they
/// are due.
int passes_until_stopped(PassesAhead& passes, int changing) {
  std::vector<int> slots(PassesAhead::slots, -1);
  passes.restart();
  for (int pass = 0; pass < 1000; ++pass) {
    passes.begin();
    slots[static_cast<std::size_t>(passes.end())] = pass < changing;
    const auto due = passes.due();
    if (due && slots[static_cast<std::size_t>(*due)] == 0) return pass + 1;
  }
  return 1000;
}

TEST(PassesAhead, AStageEndsAsManyPassesAfterItsLastChangeAsAnswersAreWaitedFor) {
  for (const int changing : {0, 1, 2, 3, 4, 50}) {
    PassesAhead passes;
    EXPECT_EQ(passes_until_stopped(passes, changing), changing + 1 + PassesAhead::count) << changing;
  }
}

TEST(PassesAhead, AnswersOfTheStageBeforeAreForgotten) {
  PassesAhead passes;
  EXPECT_EQ(passes_until_stopped(passes, 0), 1 + PassesAhead::count);
  EXPECT_EQ(passes_until_stopped(passes, 5), 6 + PassesAhead::count);
}

TEST(PassesAhead, AQuestionWithoutAPassIsNotOpen) {
  PassesAhead passes;
  EXPECT_FALSE(passes.is_open());
  passes.begin();
  EXPECT_TRUE(passes.is_open());
  EXPECT_EQ(passes.end(), 0);
  EXPECT_FALSE(passes.is_open());
}

}  // namespace
}  // namespace facet
