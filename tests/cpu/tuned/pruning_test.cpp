#include "cpu/tuned/pruning.hpp"

#include <gtest/gtest.h>

#include "support/every_executor.hpp"
#include "support/ridges.hpp"

namespace facet {
namespace {

template <class Executor>
Mask pruned(Executor& executor, const PruningParams& params, const Mask& mask, const Image<float>& depth) {
  Mask edge = mask, original(mask.size(), 9), mark(mask.size(), 9), grown(mask.size(), 9);
  prune(executor, params, depth.view(), edge.view(), {original.view(), mark.view(), grown.view()});
  return edge;
}

TEST(TunedPruning, GivesWhatThePlainOperationGives) {
  for_each_awkward_mask([](const Mask& mask) {
    const bool large = mask.width() > 100;  // there the shuffled grid is slow
    if (large && count_set(mask) > 60000) return;
    const Image<float> depth = random_depth(mask.size(), 6);
    for (const PruningParams& params : {PruningParams{PruningMode::stability, 0},
                                        {PruningMode::gonzalez, 0},
                                        {PruningMode::gonzalez, 4},
                                        {PruningMode::none, 4}})
      if (!large || params.mode != PruningMode::stability)
        expect_same_on_every_executor([&](auto& executor) { return pruned(executor, params, mask, depth); });
  });
}

TEST(TunedPruning, EatsTheSameLinesToStability) {
  const Size size{83, 61};
  for (std::uint64_t seed = 0; seed < 5; ++seed)
    for (const Image<float>& depth : {Image<float>(size, 1.0f), random_depth(size, seed)})
      expect_same_on_every_executor([&](auto& executor) {
        return pruned(executor, {PruningMode::stability, 0}, line_mask(size, seed), depth);
      });
}

TEST(TunedPruning, EatsTheSameSpiral) {
  const Image<float> depth(Size{31, 31}, 1.0f);
  for (const PruningParams& params : {PruningParams{PruningMode::stability, 0}, {PruningMode::gonzalez, 100}})
    expect_same_on_every_executor(
        [&](auto& executor) { return pruned(executor, params, spiral_mask(31), depth); });
}

}  // namespace
}  // namespace facet
