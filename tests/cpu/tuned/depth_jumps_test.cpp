#include "cpu/tuned/depth_jumps.hpp"

#include <gtest/gtest.h>

#include "support/awkward_frames.hpp"
#include "support/every_executor.hpp"
#include "support/masks.hpp"

namespace facet {
namespace {

TEST(TunedDepthJumps, AreWhatThePlainOperationMarksToTheBit) {
  for_each_awkward_depth([](const Image<float>& depth) {
    for (const auto& [jump_ratio, noise_sigmas] : {std::pair{0.015f, 4.0f}, {0.1f, 0.0f}}) {
      DepthEdgeParams params;
      params.jump_ratio = jump_ratio;
      params.noise_sigmas = noise_sigmas;
      expect_same_on_every_executor([&](auto& executor) {
        Mask edge(depth.size(), 7);
        depth_jumps(executor, params, kinect_v1_noise(), depth.view(), edge.view());
        return edge;
      });
    }
  });
}

}  // namespace
}  // namespace facet
