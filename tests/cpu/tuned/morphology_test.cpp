#include "cpu/tuned/morphology.hpp"

#include <gtest/gtest.h>

#include "support/every_executor.hpp"
#include "support/masks.hpp"

namespace facet {
namespace {

TEST(TunedMorphology, GivesWhatThePlainOperationGives) {
  for_each_awkward_mask([](const Mask& mask) {
    for (const MorphologyParams& params :
         {MorphologyParams{MorphologyMode::none}, MorphologyParams{MorphologyMode::bridge, 2},
          MorphologyParams{MorphologyMode::paper, 0, 3, 11}})
      expect_same_on_every_executor([&](auto& executor) {
        Mask edge = mask, a(mask.size(), 9), b(mask.size(), 9);
        morphology(executor, params, edge.view(), a.view(), b.view());
        return edge;
      });
  });
}

}  // namespace
}  // namespace facet
