#include "core/disjoint_sets.hpp"

#include <gtest/gtest.h>

namespace facet {
namespace {

TEST(DisjointSets, ASetIsNamedByItsSmallestMemberHoweverItWasJoined) {
  DisjointSets sets;
  sets.reset(7);
  sets.join(6, 4);
  sets.join(5, 6);
  sets.join(2, 5);
  for (const int member : {2, 4, 5, 6}) EXPECT_EQ(sets.find(member), 2) << member;
  for (const int alone : {0, 1, 3}) EXPECT_EQ(sets.find(alone), alone);
}

TEST(DisjointSets, JoiningTwoMembersOfOneSetChangesNothing) {
  DisjointSets sets;
  sets.reset(3);
  sets.join(0, 1);
  sets.join(1, 0);
  EXPECT_EQ(sets.find(1), 0);
  EXPECT_EQ(sets.find(2), 2);
}

TEST(DisjointSets, AResetForgetsWhatWasJoined) {
  DisjointSets sets;
  sets.reset(4);
  sets.join(1, 3);
  sets.reset(5);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(sets.find(i), i);
}

}  // namespace
}  // namespace facet
