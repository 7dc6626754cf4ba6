#include "cpu/due_blocks.hpp"

#include <gtest/gtest.h>
#include <utility>

namespace facet {
namespace {

using Rows = std::vector<std::pair<int, int>>;

/// The blocks at which a pass looks, and which it finds something in where `has_some` says so.
template <class HasSome>
Rows looked_at(DueBlocks& due, int turn, const HasSome& has_some) {
  Rows rows, removed;
  bool removing = false;
  const bool any = due.pass(
      turn,
      [&](int first, int behind) {
        EXPECT_FALSE(removing) << "all blocks are looked at before anything goes";
        rows.emplace_back(first, behind);
        return has_some(first);
      },
      [&](int first, int behind) {
        removing = true;
        EXPECT_TRUE(has_some(first));
        removed.emplace_back(first, behind);
      });
  EXPECT_EQ(any, !removed.empty());
  return rows;
}
const auto nowhere = [](int) { return false; };

TEST(DueBlocks, TheFirstPassLooksAtEveryRowOnce) {
  for (const int height : {0, 1, 15, 16, 17, 480}) {
    DueBlocks due;
    due.reset(height);
    int next = 0;
    for (const auto& [first, behind] : looked_at(due, 0, nowhere)) {
      EXPECT_EQ(first, next);
      EXPECT_GT(behind, first);
      next = behind;
    }
    EXPECT_EQ(next, height);
    EXPECT_TRUE(looked_at(due, 0, nowhere).empty()) << "nothing went";
  }
}

TEST(DueBlocks, WhereSomethingWentAllPassesLookAgainThereAndBeside) {
  DueBlocks due;
  due.reset(100);
  looked_at(due, 0, nowhere);
  looked_at(due, 1, [](int first) { return first == 48; });
  const Rows expected{{32, 48}, {48, 64}, {64, 80}};
  EXPECT_EQ(looked_at(due, 0, nowhere), expected);
  EXPECT_EQ(looked_at(due, 1, nowhere), expected);
  EXPECT_TRUE(looked_at(due, 0, nowhere).empty());
}

}  // namespace
}  // namespace facet
