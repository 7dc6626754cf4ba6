#include "cuda/passes_ahead.hpp"

#include <gtest/gtest.h>
#include <vector>

namespace facet {
namespace {

constexpr int kernels[2]{};

struct Course {
  std::size_t passes = 0, questions = 0;
};

/// A stage that changes something in the first `changing` of its passes; answers lie in slots until they are
/// due. What is not given to the device has no answer.
Course course_of(PassesAhead& passes, std::size_t changing, const int& kernel = kernels[0]) {
  std::vector<int> slots(PassesAhead::slots, -1);
  Course run;
  passes.restart();
  while (run.passes < 1000) {
    passes.begin();
    passes.note_kernel(&kernel);
    const bool has_changed = run.passes++ < changing;
    slots[passes.end()] = has_changed;
    const auto due = passes.due();
    if (!due) continue;
    EXPECT_TRUE(passes.is_to_give());
    ++run.questions;
    const auto answer = [&](std::size_t pass) { return slots[pass % PassesAhead::slots] != 0; };
    if (answer(*due)) continue;
    passes.ended(*due, answer);
    break;
  }
  return run;
}

std::size_t stepped(std::size_t passes) {
  return (passes + PassesAhead::step - 1) / PassesAhead::step * PassesAhead::step;
}

TEST(PassesAhead, AStageThatIsNewEndsAsManyPassesAfterItsLastChangeAsAnswersAreWaitedFor) {
  for (const std::size_t changing : {0u, 1u, 2u, 3u, 4u, 50u}) {
    PassesAhead passes;
    EXPECT_EQ(course_of(passes, changing).passes, changing + 1 + PassesAhead::count) << changing;
  }
}

TEST(PassesAhead, AStageThatNeedsAsManyPassesAsTheLastTimeAsksOnce) {
  for (const std::size_t changing : {0u, 1u, 2u, 3u, 4u, 50u, 200u}) {
    PassesAhead passes;
    course_of(passes, changing);
    for (int again = 0; again < 3; ++again) {
      const Course run = course_of(passes, changing);
      EXPECT_EQ(run.questions, 1u) << changing;
      // What was long ago is not known any more.
      if (changing < PassesAhead::slots) {
        EXPECT_EQ(run.passes, stepped(changing + 1)) << changing;
      }
    }
  }
}

TEST(PassesAhead, AStageThatNeedsMorePassesGoesOn) {
  PassesAhead passes;
  course_of(passes, 3);
  EXPECT_EQ(course_of(passes, 30).passes, 31 + PassesAhead::count);
  EXPECT_EQ(course_of(passes, 30).passes, stepped(31));
}

TEST(PassesAhead, AStageThatNeedsFewerPassesHasFewerTheNextTime) {
  PassesAhead passes;
  course_of(passes, 30);
  EXPECT_EQ(course_of(passes, 2).passes, stepped(31));
  EXPECT_EQ(course_of(passes, 2).passes, stepped(3));
}

TEST(PassesAhead, WhatAnotherStageNeededIsNotExpected) {
  PassesAhead passes;
  course_of(passes, 30, kernels[0]);
  EXPECT_EQ(course_of(passes, 1, kernels[1]).passes, 2 + PassesAhead::count);
  EXPECT_EQ(course_of(passes, 30, kernels[0]).questions, 1u);
}

TEST(PassesAhead, AQuestionWithoutAPassIsNotOpen) {
  PassesAhead passes;
  EXPECT_FALSE(passes.is_open());
  passes.begin();
  EXPECT_TRUE(passes.is_open());
  EXPECT_EQ(passes.end(), 0u);
  EXPECT_FALSE(passes.is_open());
}

}  // namespace
}  // namespace facet
