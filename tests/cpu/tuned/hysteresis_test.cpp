#include "cpu/tuned/hysteresis.hpp"

#include <gtest/gtest.h>

#include "stage/hysteresis.hpp"
#include "support/every_executor.hpp"
#include "support/ridges.hpp"

namespace facet {
namespace {

template <class Executor>
Mask hysteresis_of(Executor& executor, const Mask& ridge) {
  Mask copy = ridge, edge(ridge.size(), 9);
  hysteresis(executor, copy.view(), edge.view());
  return edge;
}

TEST(TunedHysteresis, GivesWhatThePlainOperationGives) {
  for (const Size size : awkward_sizes) {
    const Mask ridge = random_ridges(size, 7);
    expect_same_on_every_executor([&](auto& executor) { return hysteresis_of(executor, ridge); });
  }
  for_each_awkward_mask([](const Mask& mask) {  // all weak: nothing is kept
    expect_same_on_every_executor([&](auto& executor) { return hysteresis_of(executor, mask); });
  });
}

TEST(TunedHysteresis, FollowsTheSameSpiral) {
  Mask spiral = spiral_mask(41);
  spiral(0, 0) = static_cast<std::uint8_t>(Ridge::strong);
  expect_same_on_every_executor([&](auto& executor) { return hysteresis_of(executor, spiral); });
}

}  // namespace
}  // namespace facet
