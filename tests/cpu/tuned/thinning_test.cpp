#include "cpu/tuned/thinning.hpp"

#include <gtest/gtest.h>

#include "stage/thinning.hpp"
#include "support/every_executor.hpp"
#include "support/ridges.hpp"

namespace facet {
namespace {

template <class Executor>
Mask thinned(Executor& executor, const Mask& mask) {
  Mask edge = mask, mark(mask.size());
  thin(executor, edge.view(), mark.view());
  return edge;
}

TEST(TunedThinning, GivesWhatThePlainOperationGives) {
  for_each_awkward_mask([](const Mask& mask) {
    if (count_set(mask) > 130000) return;  // thick masks take many passes
    expect_same_on_every_executor([&](auto& executor) { return thinned(executor, mask); });
  });
}

TEST(TunedThinning, GivesTheSameOnThickBlobsAndOnNoise) {
  for (std::uint64_t seed = 0; seed < 5; ++seed)
    for (const Mask& mask : {blob_mask({83, 61}, seed, 25), random_mask({83, 61}, seed, 0.7f)})
      expect_same_on_every_executor([&](auto& executor) { return thinned(executor, mask); });
}

}  // namespace
}  // namespace facet
