#include <gtest/gtest.h>
#include <limits>

#include "cpu/cpu_pipeline.hpp"
#include "pipeline/modes.hpp"
#include "support/expect_error.hpp"

namespace facet {
namespace {

const Camera camera{525, 525, 15, 3};

FrameResult processed(const PipelineParams& params, const Image<float>& depth_m,
                      const Camera& with = camera) {
  FrameResult result;
  make_cpu_pipeline(params, 1)->process({depth_m.view(), with}, result);
  return result;
}

void expect_nothing_found(const FrameResult& result, Size size, const std::string& what) {
  EXPECT_TRUE(result.surfaces.empty()) << what;
  EXPECT_FALSE(result.note.empty()) << what;
  ASSERT_EQ(result.labels.size(), size) << what;
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) ASSERT_EQ(result.labels(x, y), 0) << what;
}

/// The default and the paper's pipeline drop what is too small to be a surface.
const Mode validating_modes[]{{"default", {}}, {"paper", paper_params()}};

TEST(AwkwardInput, AFrameWithoutAnyDepthHasNoSurfaceAndSaysSo) {
  for (const Mode& mode : modes)
    for (const Size size : {Size{1, 1}, Size{3, 3}, Size{31, 7}, Size{33, 9}, Size{160, 120}}) {
      const FrameResult result = processed(mode.params, Image<float>(size, 0.0f));
      expect_nothing_found(result, size, mode.name);
      EXPECT_EQ(result.note, "the frame has no measured depth");
    }
}

TEST(AwkwardInput, CountsOfAnotherSizeAreRefused) {
  const Image<float> depth(Size{31, 7}, 1.0f);
  const Image<std::uint16_t> counts(Size{31, 6}, 1000);
  FrameResult result;
  expect_error(ErrorKind::data, "whole units has another size", [&] {
    make_cpu_pipeline({}, 1)->process({depth.view(), camera, {}, {}, DepthCounts{counts.view(), 0.001}},
                                      result);
  });
}

TEST(AwkwardInput, AFrameTooSmallForASurfaceSaysWhy) {
  for (const Mode& mode : validating_modes)
    for (const Size size : {Size{1, 1}, Size{3, 3}, Size{7, 1}, Size{1, 9}}) {
      const FrameResult result = processed(mode.params, Image<float>(size, 1.0f));
      expect_nothing_found(result, size, mode.name);
      ASSERT_FALSE(result.rejected.empty()) << mode.name;
      EXPECT_EQ(result.rejected[0].reason, reject_reason::too_small);
    }
}

TEST(AwkwardInput, SmallNoisyFramesOfAnySizeAreProcessed) {
  for (const Mode& mode : modes)
    for (const Size size : {Size{1, 1}, Size{2, 5}, Size{3, 3}, Size{31, 7}, Size{33, 9}, Size{64, 1}}) {
      Image<float> depth(size);
      for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
          depth(x, y) = (x * 7 + y * 13) % 5 == 0 ? 0.0f : 0.8f + 0.1f * static_cast<float>(x % 3);
      const FrameResult result = processed(mode.params, depth);
      EXPECT_EQ(result.labels.size(), size);
      EXPECT_EQ(result.edges.size(), size);
      EXPECT_EQ(result.surfaces.empty(), !result.note.empty()) << mode.name;
    }
}

TEST(AwkwardInput, AnEmptyImageHasNoSurface) {
  for (const Mode& mode : modes)
    EXPECT_FALSE(processed(mode.params, Image<float>()).note.empty()) << mode.name;
}

TEST(AwkwardInput, AnImageOfRowsWithPaddingGivesTheSameAsOneWithout) {
  std::vector<float> packed(33 * 29);
  Image<float> padded({33, 29});
  ASSERT_NE(padded.stride(), 33);
  for (int y = 0; y < 29; ++y)
    for (int x = 0; x < 33; ++x)
      packed[static_cast<std::size_t>(33 * y + x)] = padded(x, y) = x < 16 ? 1.0f : 1.3f;
  const FrameResult a = processed({}, padded);
  FrameResult b;
  make_cpu_pipeline({}, 1)->process({{packed.data(), 33, 29, 33}, camera}, b);
  ASSERT_EQ(a.surfaces.size(), 2u);
  ASSERT_EQ(b.surfaces.size(), 2u);
  for (int y = 0; y < 29; ++y)
    for (int x = 0; x < 33; ++x) ASSERT_EQ(a.labels(x, y), b.labels(x, y));
}

TEST(AwkwardInput, NegativeInfiniteAndNaNDepthAreDataErrors) {
  for (const float wrong :
       {-0.5f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
        -std::numeric_limits<float>::infinity()}) {
    Image<float> depth({31, 7}, 1.0f);
    depth(30, 6) = wrong;
    expect_error(ErrorKind::data, "depth: row 6", [&] { processed({}, depth); });
  }
}

TEST(AwkwardInput, ACameraThatCannotBeRightIsADataError) {
  const Image<float> depth({31, 7}, 1.0f);
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(),
                  infinite = std::numeric_limits<float>::infinity();
  for (const Camera& wrong :
       {Camera{}, Camera{-525, 525, 15, 3}, Camera{525, 0, 15, 3}, Camera{nan, 525, 15, 3},
        Camera{525, infinite, 15, 3}, Camera{525, 525, nan, 3}, Camera{525, 525, 15, infinite}})
    expect_error(ErrorKind::data, "camera", [&] { processed({}, depth, wrong); });
}

TEST(AwkwardInput, AParameterOutOfRangeIsRejectedBeforeAnyFrame) {
  PipelineParams params;
  params.cd.radius_px = 0;
  expect_error(ErrorKind::config, "cd.radius_px", [&] { make_cpu_pipeline(params, 1); });
}

TEST(AwkwardInput, AFrameAfterABadOneIsProcessedAsIfItHadNotBeen) {
  const auto pipeline = make_cpu_pipeline({}, 1);
  Image<float> bad({64, 48}, -1.0f), good({64, 48}, 1.0f);
  FrameResult result;
  EXPECT_THROW(pipeline->process({bad.view(), camera}, result), Error);
  pipeline->process({good.view(), camera}, result);
  EXPECT_EQ(result.surfaces.size(), 1u);
}

}  // namespace
}  // namespace facet
