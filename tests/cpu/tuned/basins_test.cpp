#include "cpu/tuned/basins.hpp"

#include <gtest/gtest.h>

#include "stage/labelling.hpp"
#include "support/every_executor.hpp"
#include "support/masks.hpp"
#include "support/ridges.hpp"

namespace facet {
namespace {

template <class Executor>
Image<std::int32_t> basins_of(Executor& executor, const Image<float>& strength, const Mask& distance) {
  const CreaseHeight height{strength.view(), distance.view(), 2, 0.2f};
  Mask off_floor(strength.size());
  Image<std::int32_t> root(strength.size(), 77);
  mark_off_floor(executor, height, off_floor.view());
  label_components(executor, Image<float>(strength.size(), 1.0f).view(), off_floor.view(), root.view());
  crease_basins(executor, height, root.view());
  return root;
}

/// Few different values: many neighbours are equally high.
Image<float> terraces(Size size) {
  return make_image<float>(
      size, [](int x, int y) { return 0.25f * static_cast<float>(static_cast<int>(5 * noise_at(3, x, y))); });
}
Mask distances(Size size) {
  return make_image<std::uint8_t>(size, [](int x, int y) { return std::abs(x - 9 - y / 3) / 2; });
}

TEST(TunedBasins, GiveWhatThePlainOperationGives) {
  for (const Size size : awkward_sizes)
    for (const Image<float>& strength : {random_depth(size, 3), terraces(size), Image<float>(size, 1.0f)})
      expect_same_on_every_executor(
          [&](auto& executor) { return basins_of(executor, strength, distances(size)); });
}

TEST(TunedBasins, FollowALongWayDown) {
  const Size size{200, 3};
  const auto slope = make_image<float>(size, [](int x, int) { return 1 + 0.001f * static_cast<float>(x); });
  expect_same_on_every_executor([&](auto& executor) { return basins_of(executor, slope, Mask(size, 9)); });
}

TEST(TunedBasins, AreTheSameForFrameAfterFrameFromOneExecutor) {
  CpuExecutor reused;
  for (const Size size : {Size{83, 61}, Size{31, 7}, Size{0, 0}, Size{90, 60}}) {
    CpuExecutor fresh;
    EXPECT_TRUE(same_image(basins_of(reused, terraces(size), distances(size)),
                           basins_of(fresh, terraces(size), distances(size))));
  }
}

}  // namespace
}  // namespace facet
