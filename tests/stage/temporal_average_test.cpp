#include "stage/temporal_average.hpp"

#include <gtest/gtest.h>
#include <tuple>
#include <vector>

#include "support/awkward_frames.hpp"
#include "support/every_executor.hpp"

namespace facet {
namespace {

constexpr TemporalParams mean_of_five{true, TemporalMode::mean, 5};
constexpr TemporalParams robust_of_five{true, TemporalMode::robust, 5};

/// The average of one pixel after it read these values, one per frame.
float average_of(const TemporalParams& params, const std::vector<float>& readings) {
  CpuExecutor executor;
  TemporalHistory<CpuExecutor> history;
  Image<float> frame(Size{1, 1}), out(Size{1, 1});
  for (const float z : readings) {
    frame(0, 0) = z;
    history.push(executor, std::as_const(frame).view(), params.frames);
  }
  temporal_average(executor, params, kinect_v1_noise(), history, out.view());
  return out(0, 0);
}

TEST(TemporalAverage, IsTheMeanOfTheFramesByHand) {  // eq. 3
  EXPECT_NEAR(average_of(mean_of_five, {1.00f, 1.01f, 1.03f, 0.99f, 1.02f}), 5.05 / 5, 1e-6);
}

TEST(TemporalAverage, CoversFiveFramesTheCurrentOneIncluded) {
  EXPECT_EQ(average_of(mean_of_five, {1}), 1);
  EXPECT_EQ(average_of(mean_of_five, {1, 2, 3, 4, 5}), 3);
  EXPECT_EQ(average_of(mean_of_five, {1, 2, 3, 4, 5, 6}), 4);
  EXPECT_EQ(average_of(mean_of_five, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}), 10);
}

TEST(TemporalAverage, CountsNoMissingReadings) {
  EXPECT_NEAR(average_of(mean_of_five, {1.0f, 0, 1.2f, 0, 1.4f}), 1.2, 1e-6);
  EXPECT_EQ(average_of(mean_of_five, {0, 0, 0, 0, 2}), 2);
  EXPECT_NEAR(average_of(robust_of_five, {1.0f, 0, 1.002f, 0, 0}), 1.001, 1e-6);
}

TEST(TemporalAverage, LeavesMissingWhatNoFrameSaw) {
  EXPECT_EQ(average_of(mean_of_five, {0, 0, 0}), 0);
  EXPECT_EQ(average_of(robust_of_five, {0, 0, 0}), 0);
}

TEST(TemporalAverage, RobustModeKeepsAMovedEdgeSharp) {
  const std::vector<float> edge_passed{2.0f, 2.0f, 1.0f, 1.0f, 1.0f};
  EXPECT_EQ(average_of(robust_of_five, edge_passed), 1.0f);
  EXPECT_NEAR(average_of(mean_of_five, edge_passed), 1.4, 1e-6) << "eq. 3 makes a depth that nothing has";
}

TEST(TemporalAverage, RobustModeEqualsTheMeanWhereReadingsDifferByNoiseOnly) {
  const std::vector<float> noisy{1.001f, 0.999f, 1.002f, 1.0f, 0.9985f};
  EXPECT_NEAR(average_of(robust_of_five, noisy), average_of(mean_of_five, noisy), 1e-6);
}

TEST(TemporalAverage, ReducesNoiseByTheRootOfTheNumberOfFrames) {
  double squares = 0;
  const int pixels = 2000;
  for (int i = 0; i < pixels; ++i) {
    std::vector<float> readings;
    for (int k = 0; k < 4; ++k) readings.push_back(1 + 0.002f * (noise_at(1, i, k) - 0.5f));
    const double error = static_cast<double>(average_of(mean_of_five, readings)) - 1;
    squares += error * error;
  }
  const double single = 0.002 / std::sqrt(12.0);
  EXPECT_NEAR(std::sqrt(squares / pixels) / single, 0.5, 0.05);
}

TEST(TemporalHistory, StartsOverWithAFrameOfAnotherSize) {
  CpuExecutor executor;
  TemporalHistory<CpuExecutor> history;
  const Image<float> frame(Size{4, 4}, 1.0f), other(Size{8, 2}, 2.0f);
  for (int i = 0; i < 3; ++i) history.push(executor, frame.view(), 5);
  EXPECT_EQ(history.count(), 3);
  history.push(executor, other.view(), 5);
  EXPECT_EQ(history.count(), 1);
  Image<float> out(Size{8, 2});
  temporal_average(executor, mean_of_five, kinect_v1_noise(), history, out.view());
  EXPECT_EQ(out(7, 1), 2.0f);
}

TEST(TemporalHistory, ForgetsWhenCleared) {
  CpuExecutor executor;
  TemporalHistory<CpuExecutor> history;
  const Image<float> frame(Size{1, 1}, 1.0f);
  for (int i = 0; i < 7; ++i) history.push(executor, frame.view(), 5);
  EXPECT_EQ(history.count(), 5);
  history.clear();
  EXPECT_EQ(history.count(), 0);
}

TEST(TemporalAverage, IsTheSameOnEveryExecutor) {
  for (const Size size : awkward_sizes)
    for (const TemporalParams& params : {mean_of_five, robust_of_five})
      expect_same_on_every_executor([&](auto& executor) {
        TemporalHistory<std::remove_reference_t<decltype(executor)>> history;
        for (std::uint64_t k = 0; k < 6; ++k) {
          const Image<float> frame = random_depth(size, k / 3);
          history.push(executor, frame.view(), params.frames);
        }
        Image<float> out(size);
        temporal_average(executor, params, kinect_v1_noise(), history, out.view());
        return out;
      });
}

}  // namespace
}  // namespace facet
