#include "cpu/tuned/temporal_average.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "support/awkward_frames.hpp"
#include "support/every_executor.hpp"

namespace facet {
namespace {

TEST(TunedTemporalAverage, GivesWhatThePlainOperationGivesToTheBit) {
  for_each_awkward_depth([](const Image<float>& depth) {
    for (const TemporalMode mode : {TemporalMode::mean, TemporalMode::robust})
      for (const int window : {1, 2, 5, max_temporal_frames}) {
        if (window > 5 && depth.width() > 100) continue;  // many frames on the shuffled grid
        expect_same_on_every_executor([&](auto& executor) {
          TemporalHistory<std::remove_reference_t<decltype(executor)>> history;
          Image<float> frame(depth.size()), out(depth.size(), 7.0f);
          for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(window); ++i) {
            for (int y = 0; y < depth.height(); ++y)
              for (int x = 0; x < depth.width(); ++x) {
                // Some readings jump or drop out.
                const float chance = random_uniform(9, i, static_cast<std::uint64_t>(y * depth.width() + x));
                frame(x, y) =
                    depth(x, y) * (chance < 0.1f ? 0.0f : (chance < 0.2f ? 1.3f : 1 + 0.004f * chance));
              }
            history.push(executor, std::as_const(frame).view(), window);
          }
          temporal_average(executor, {true, mode, window}, kinect_v1_noise(), history, out.view());
          return out;
        });
      }
  });
}

}  // namespace
}  // namespace facet
