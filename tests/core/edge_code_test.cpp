#include "core/edge_code.hpp"

#include <gtest/gtest.h>

namespace facet {
namespace {

// The codes are written to files: they must never change.
TEST(EdgeCode, IsTheKindPlusSixteenWhereAFingerReaches) {
  EXPECT_EQ(edge_code(EdgeKind::none, false), 0);
  EXPECT_EQ(edge_code(EdgeKind::depth, true), 17);
  EXPECT_EQ(edge_code(EdgeKind::convex, true), 18);
  EXPECT_EQ(edge_code(EdgeKind::convex, false), 2);
  EXPECT_EQ(edge_code(EdgeKind::concave, false), 3);
}

TEST(EdgeCode, GivesItsKindBackWhetherAFingerReachesOrNot) {
  for (const EdgeKind kind : {EdgeKind::none, EdgeKind::depth, EdgeKind::convex, EdgeKind::concave})
    for (const bool graspable : {false, true}) EXPECT_EQ(edge_kind_of(edge_code(kind, graspable)), kind);
}

}  // namespace
}  // namespace facet
