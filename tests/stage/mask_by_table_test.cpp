#include "stage/mask_by_table.hpp"

#include <gtest/gtest.h>
#include <tuple>

#include "support/every_executor.hpp"
#include "support/masks.hpp"

namespace facet {
namespace {

/// Deletes every pixel with an odd number of neighbours, once.
template <class Executor>
std::tuple<Mask, Mask> without_odd(Executor& executor, const Mask& mask) {
  static constexpr NeighbourTable odd = make_neighbour_table([](unsigned code) {
    int count = 0;
    for (unsigned i = 0; i < 8; ++i) count += code >> i & 1u;
    return count % 2 == 1;
  });
  std::tuple out{mask, Mask(mask.size())};
  auto& [kept, mark] = out;
  executor.for_each_set(kept.view(), MarkByTableOp{odd, kept.view(), mark.view()});
  executor.for_each_set(kept.view(), DeleteMarkedOp{kept.view(), mark.view(), executor.changed_flag()});
  return out;
}

TEST(MaskByTable, DeletesWhatItMarkedInTheStateBeforeThePass) {
  const Mask mask = random_mask({33, 9}, 2, 0.5f);
  CpuExecutor executor;
  const auto [kept, mark] = without_odd(executor, mask);
  EXPECT_TRUE(executor.take_changed());
  EXPECT_TRUE(same_image(mark, Mask(mask.size()))) << "marks are taken back";
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 33; ++x) {
      int neighbours = 0;
      for (int ny = y - 1; ny <= y + 1; ++ny)
        for (int nx = x - 1; nx <= x + 1; ++nx)
          neighbours += (nx != x || ny != y) && mask.size().contains(nx, ny) && mask(nx, ny);
      EXPECT_EQ(kept(x, y), mask(x, y) && neighbours % 2 == 0 ? 1 : 0);
    }
}

TEST(MaskByTable, RaisesNoFlagWhereNothingIsDeleted) {
  CpuExecutor executor;
  without_odd(executor, Mask(Size{33, 9}));
  EXPECT_FALSE(executor.take_changed());
}

TEST(MaskByTable, IsTheSameOnEveryExecutor) {
  for_each_awkward_mask([](const Mask& mask) {
    expect_same_on_every_executor([&](auto& executor) { return without_odd(executor, mask); });
  });
}

}  // namespace
}  // namespace facet
