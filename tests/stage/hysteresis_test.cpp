#include "stage/hysteresis.hpp"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "support/every_executor.hpp"
#include "support/mat.hpp"
#include "support/ridges.hpp"

namespace facet {
namespace {

template <class Executor>
Mask hysteresis_of(Executor& executor, const Mask& ridge) {
  Mask copy = ridge, edge(ridge.size(), 9);
  hysteresis(executor, copy.view(), edge.view());
  return edge;
}
Mask hysteresis_of(const Mask& ridge) {
  CpuExecutor executor;
  return hysteresis_of(executor, ridge);
}

/// 8-connected components of all ridges that hold a strong one, by OpenCV's labelling.
Mask components_with_strong_ridge(Mask ridge) {
  cv::Mat_<int> label;
  const int count = cv::connectedComponents(as_mat(ridge) > 0, label, 8, CV_32S);
  std::vector<bool> strong(static_cast<std::size_t>(count));
  for (int y = 0; y < ridge.height(); ++y)
    for (int x = 0; x < ridge.width(); ++x)
      if (ridge(x, y) == 2) strong[static_cast<std::size_t>(label(y, x))] = true;
  return make_image<std::uint8_t>(ridge.size(), [&](int x, int y) {
    return ridge(x, y) > 0 && strong[static_cast<std::size_t>(label(y, x))] ? 1 : 0;
  });
}

TEST(Hysteresis, KeepsTheComponentsThatHoldAStrongRidge) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Mask ridge = random_ridges({83, 61}, seed);
    EXPECT_TRUE(same_image(hysteresis_of(ridge), components_with_strong_ridge(ridge)));
  }
}

TEST(Hysteresis, FollowsAWeakSpiralToItsEnd) {
  Mask ridge = spiral_mask(41);
  ridge(0, 0) = static_cast<std::uint8_t>(Ridge::strong);
  EXPECT_TRUE(same_image(hysteresis_of(ridge), spiral_mask(41)));
}

TEST(Hysteresis, DropsWeakRidgesWithoutAStrongOne) {
  EXPECT_TRUE(same_image(hysteresis_of(spiral_mask(41)), Mask(Size{41, 41})));
}

TEST(Hysteresis, IsTheSameOnEveryExecutor) {
  for (const Size size : awkward_sizes) {
    const Mask ridge = random_ridges(size, 7);
    expect_same_on_every_executor([&](auto& executor) { return hysteresis_of(executor, ridge); });
  }
  expect_same_on_every_executor([&](auto& executor) {
    Mask ridge = spiral_mask(21);
    ridge(0, 0) = 2;
    return hysteresis_of(executor, ridge);
  });
}

}  // namespace
}  // namespace facet
