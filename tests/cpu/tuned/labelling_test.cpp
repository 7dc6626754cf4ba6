#include "cpu/tuned/labelling.hpp"

#include <gtest/gtest.h>

#include "stage/labelling.hpp"
#include "support/every_executor.hpp"
#include "support/ridges.hpp"

namespace facet {
namespace {

template <class Executor>
Image<std::int32_t> labels_of(Executor& executor, const Image<float>& depth, const Mask& edge) {
  Image<std::int32_t> root(depth.size(), 77);
  label_components(executor, depth.view(), edge.view(), root.view());
  return root;
}

TEST(TunedLabelling, GivesWhatThePlainOperationGives) {
  for_each_awkward_mask([](const Mask& edge) {
    const Image<float> depth = random_depth(edge.size(), 3);
    expect_same_on_every_executor([&](auto& executor) { return labels_of(executor, depth, edge); });
  });
}

TEST(TunedLabelling, JoinsTheTurnsOfASpiral) {
  const Image<float> depth(Size{41, 41}, 1.0f);
  expect_same_on_every_executor([&](auto& executor) { return labels_of(executor, depth, spiral_mask(41)); });
}

TEST(TunedLabelling, GivesTheSameForFrameAfterFrameFromOneExecutor) {
  CpuExecutor reused;
  for (const Size size : {Size{83, 61}, Size{31, 7}, Size{0, 0}, Size{90, 60}}) {
    CpuExecutor fresh;
    const Image<float> depth = random_depth(size, 4);
    const Mask edge = line_mask(size, 5);
    EXPECT_TRUE(same_image(labels_of(reused, depth, edge), labels_of(fresh, depth, edge)));
  }
}

}  // namespace
}  // namespace facet
