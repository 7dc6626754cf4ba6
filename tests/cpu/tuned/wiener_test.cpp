#include "cpu/tuned/wiener.hpp"

#include <gtest/gtest.h>

#include "support/awkward_frames.hpp"
#include "support/every_executor.hpp"

namespace facet {
namespace {

void expect_same(const WienerParams& params, const Image<float>& depth) {
  expect_same_on_every_executor([&](auto& executor) {
    Image<float> mean(depth.size(), 7.0f), variance(depth.size(), 7.0f), out(depth.size(), 7.0f);
    wiener(executor, params, kinect_v1_noise(), depth.view(), mean.view(), variance.view(), out.view());
    return out;
  });
}

TEST(TunedWiener, GivesWhatThePlainFilterGivesToTheBit) {
  for_each_awkward_depth([](const Image<float>& depth) {
    for (const WienerNoise noise : {WienerNoise::sensor, WienerNoise::mean}) {
      expect_same({true, WienerGain::paper, noise, 3, false}, depth);
      expect_same({true, WienerGain::lim, noise, 5, true}, depth);
      if (depth.width() > 100) continue;  // the shuffled grid is slow
      expect_same({true, WienerGain::lim, noise, 3, true}, depth);
      expect_same({true, WienerGain::paper, noise, 5, false}, depth);
      expect_same({true, WienerGain::paper, noise, 7, false}, depth);
      expect_same({true, WienerGain::lim, noise, 7, true}, depth);
    }
  });
}

}  // namespace
}  // namespace facet
