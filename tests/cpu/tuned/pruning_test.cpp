#include "cpu/tuned/pruning.hpp"

#include <gtest/gtest.h>

#include "support/every_executor.hpp"
#include "support/ridges.hpp"

namespace facet {
namespace {

template <class Executor>
Mask pruned(Executor& executor, const PruningParams& params, const Mask& mask) {
  Mask edge = mask, original(mask.size(), 9), mark(mask.size(), 9), grown(mask.size(), 9);
  const Image<float> depth(mask.size(), 1.0f);
  prune(executor, params, depth.view(), edge.view(), {original.view(), mark.view(), grown.view()});
  return edge;
}

TEST(TunedPruning, GivesWhatThePlainOperationGives) {
  for_each_awkward_mask([](const Mask& mask) {
    if (count_set(mask) > 60000) return;  // thick masks take hundreds of passes
    for (const PruningParams& params : {PruningParams{PruningMode::stability, 0},
                                        {PruningMode::gonzalez, 0},
                                        {PruningMode::gonzalez, 4},
                                        {PruningMode::none, 4}})
      expect_same_on_every_executor([&](auto& executor) { return pruned(executor, params, mask); });
  });
}

TEST(TunedPruning, EatsTheSameSpiral) {
  for (const PruningParams& params : {PruningParams{PruningMode::stability, 0}, {PruningMode::gonzalez, 100}})
    expect_same_on_every_executor([&](auto& executor) { return pruned(executor, params, spiral_mask(31)); });
}

}  // namespace
}  // namespace facet
