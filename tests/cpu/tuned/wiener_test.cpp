#include "cpu/tuned/wiener.hpp"

#include <gtest/gtest.h>
#include <tuple>

#include "support/awkward_frames.hpp"
#include "support/every_executor.hpp"

namespace facet {
namespace {

template <int radius, bool detrend>
void expect_same_statistics(const Image<float>& depth) {
  expect_same_on_every_executor([&](auto& executor) {
    Image<float> mean(depth.size(), 7.0f), variance(depth.size(), 7.0f);
    window_statistics(executor,
                      WienerStatisticsOp<radius, detrend>{depth.view(), mean.view(), variance.view()});
    return std::make_tuple(std::move(mean), std::move(variance));
  });
}

TEST(TunedWiener, GivesWhatThePlainStatisticsGiveToTheBit) {
  for_each_awkward_depth([](const Image<float>& depth) {
    expect_same_statistics<1, false>(depth);
    expect_same_statistics<2, true>(depth);
    if (depth.width() > 100) return;  // the shuffled grid is slow
    expect_same_statistics<1, true>(depth);
    expect_same_statistics<2, false>(depth);
    expect_same_statistics<3, false>(depth);
    expect_same_statistics<3, true>(depth);
  });
}

}  // namespace
}  // namespace facet
