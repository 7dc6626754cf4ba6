#include "cpu/tuned/ownership.hpp"

#include <gtest/gtest.h>

#include "stage/ownership.hpp"
#include "support/awkward_frames.hpp"
#include "support/every_executor.hpp"
#include "support/masks.hpp"

namespace facet {
namespace {

using Labels = Image<std::uint16_t>;

template <class Executor>
Labels given_back(Executor& executor, const Image<float>& depth, const Labels& label) {
  Labels out = label, choice(label.size());
  Mask open(label.size());
  give_back_pixels(executor, 0.02f, 4, kinect_v1_noise(), depth.view(), out.view(), open.view(),
                   choice.view());
  return out;
}

TEST(TunedOwnership, GivesWhatThePlainOperationGives) {
  for (const Size size : awkward_sizes) {
    const Image<float> depth = random_depth(size, 3);
    const auto label = make_image<std::uint16_t>(size, [](int x, int y) {
      const bool unowned = x % 9 < 3 || y % 7 < 2;
      return unowned ? 0 : 1 + (x / 9 + 3 * (y / 7)) % 5;
    });
    expect_same_on_every_executor([&](auto& executor) { return given_back(executor, depth, label); });
  }
}

TEST(TunedOwnership, FillsALargeGapFromBothSidesInTheSameWay) {
  const Size size{61, 33};
  const auto depth = make_image<float>(size, [](int x, int y) {
    return 1.0f + 0.004f * static_cast<float>(x % 7) + 0.003f * static_cast<float>(y % 5);
  });
  const auto label = make_image<std::uint16_t>(size, [](int x, int) { return x < 4 ? 1 : (x > 56 ? 2 : 0); });
  expect_same_on_every_executor([&](auto& executor) { return given_back(executor, depth, label); });
}

}  // namespace
}  // namespace facet
