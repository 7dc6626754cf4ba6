#include "cpu/tuned/edge_distance.hpp"

#include <gtest/gtest.h>

#include "stage/edge_distance.hpp"
#include "support/every_executor.hpp"
#include "support/masks.hpp"

namespace facet {
namespace {

TEST(TunedEdgeDistance, IsThatOfThePlainRelaxation) {
  for_each_awkward_depth([](const Image<float>& depth) {
    for (const int cap : {1, 2, 4, 17}) {
      if (cap == 17 && depth.width() > 100) continue;  // the shuffled grid is slow
      const Mask edge = random_mask(depth.size(), 5, 0.01f);
      expect_same_on_every_executor([&](auto& executor) {
        Mask distance(depth.size(), 7), scratch(depth.size(), 77);
        edge_distance(executor, depth.view(), edge.view(), cap, distance.view(), scratch.view());
        return distance;
      });
    }
  });
}

}  // namespace
}  // namespace facet
