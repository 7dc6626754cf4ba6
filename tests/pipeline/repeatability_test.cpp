#include <gtest/gtest.h>

#include "cpu/cpu_pipeline.hpp"
#include "pipeline/modes.hpp"
#include "pipeline/results.hpp"
#include "pipeline/small_scene.hpp"

namespace facet {
namespace {

constexpr Size size{160, 120};
const Camera camera = scaled_camera(size);

FrameResult still(Pipeline& pipeline, const Image<float>& depth) {
  FrameResult result;
  pipeline.reset_history();
  pipeline.process({depth.view(), camera}, result);
  return result;
}

TEST(Repeatability, ThePipelineGivesTheSameTwiceForTheSameFrame) {
  const Image<float> depth = small_measured_scene(1, size, camera, 1);
  for (const Mode& mode : modes) {
    const auto pipeline = make_cpu_pipeline(mode.params, 1);
    const FrameResult first = still(*pipeline, depth);
    EXPECT_FALSE(first.surfaces.empty()) << mode.name;
    expect_equal_results(first, still(*pipeline, depth), mode.name);
  }
}

TEST(Repeatability, AStillFrameDoesNotDependOnTheFramesBefore) {
  const Image<float> depth = small_measured_scene(1, size, camera, 1);
  const Image<float> other = small_measured_scene(5, size, camera, 2);
  for (const Mode& mode : modes) {
    const auto fresh = make_cpu_pipeline(mode.params, 1), used = make_cpu_pipeline(mode.params, 1);
    FrameResult result;
    for (int i = 0; i < 7; ++i) used->process({other.view(), camera}, result);
    expect_equal_results(still(*fresh, depth), still(*used, depth), mode.name);
  }
}

TEST(Repeatability, ASequenceSmoothsTheNoiseOfAStillScene) {
  const auto pipeline = make_cpu_pipeline({}, 1);
  const Image<float> depth = small_measured_scene(1, size, camera, 1);
  FrameResult alone = still(*pipeline, depth), averaged;
  pipeline->reset_history();
  for (std::uint64_t seed = 5; seed > 0; --seed)
    pipeline->process({small_measured_scene(1, size, camera, seed).view(), camera}, averaged);
  ASSERT_FALSE(alone.surfaces.empty() || averaged.surfaces.empty());
  const auto largest = [](const FrameResult& result) {
    return *std::max_element(result.surfaces.begin(), result.surfaces.end(),
                             [](const Surface& a, const Surface& b) { return a.area_px < b.area_px; });
  };
  EXPECT_LT(largest(averaged).rms_m, largest(alone).rms_m);
}

TEST(Repeatability, AFrameOfAnotherSizeStartsOver) {
  for (const Mode& mode : modes) {
    const auto fresh = make_cpu_pipeline(mode.params, 1), used = make_cpu_pipeline(mode.params, 1);
    const Size other{97, 61};
    const Image<float> depth = small_measured_scene(1, size, camera, 1);
    const Image<float> smaller = small_measured_scene(1, other, scaled_camera(other), 1);
    FrameResult expected, result;
    fresh->process({depth.view(), camera}, expected);
    used->process({smaller.view(), scaled_camera(other)}, result);
    used->process({depth.view(), camera}, result);
    expect_equal_results(expected, result, mode.name);
  }
}

TEST(Repeatability, AResultThatIsUsedAgainHoldsNothingOfTheFrameBefore) {
  const Image<float> depth = small_measured_scene(1, size, camera, 1), none(size, 0.0f);
  for (const Mode& mode : modes) {
    const auto pipeline = make_cpu_pipeline(mode.params, 1);
    FrameResult result;
    pipeline->process({depth.view(), camera}, result);
    pipeline->reset_history();
    pipeline->process({none.view(), camera}, result);
    expect_equal_results(still(*pipeline, none), result, mode.name);
  }
}

TEST(Repeatability, PipelinesThatTakeTurnsAndRunInPartsGiveWhatOneGivesAtOnce) {
  for (const Mode& mode : modes) {
    const auto alone = make_cpu_pipeline(mode.params, 1);
    const auto turns = make_cpu_pipelines(2, mode.params, 1);
    FrameResult expected, results[2];
    for (std::size_t i = 0; i < 4; ++i) {
      const Image<float> depth = small_measured_scene(1, size, camera, i);
      const FrameInput frame{depth.view(), camera};
      alone->process(frame, expected);
      for (const StageRange part : {StageRange{StageId::temporal, StageId::wiener},
                                    {StageId::gradient, StageId::validation},
                                    {StageId::pose, StageId::objects}})
        turns[i % 2]->run(part, frame, results[i % 2]);
      expect_equal_results(expected, results[i % 2], mode.name);
    }
  }
}

TEST(Repeatability, TheSeedChangesPosesALittleAndNothingElse) {
  const Image<float> depth = small_measured_scene(1, size, camera, 1);
  const FrameResult a = still(*make_cpu_pipeline({}, 1), depth), b = still(*make_cpu_pipeline({}, 2), depth);
  expect_equal_images(a.labels, b.labels, "labels");
  ASSERT_EQ(a.surfaces.size(), b.surfaces.size());
  for (std::size_t i = 0; i < a.surfaces.size(); ++i)
    EXPECT_EQ(a.surfaces[i].pose.has_value(), b.surfaces[i].pose.has_value());
}

TEST(Repeatability, EveryTimedStageIsPartOfTheTotal) {
  const FrameResult result = still(*make_cpu_pipeline({}, 1), small_measured_scene(1, size, camera, 1));
  for (const double ms : result.times.stage_ms) EXPECT_GE(ms, 0);
  EXPECT_GT(result.times.total_ms, 0);
  EXPECT_GE(result.times.unattributed_ms(), 0);
  EXPECT_LT(result.times.unattributed_ms(), 0.5 * result.times.total_ms);
}

}  // namespace
}  // namespace facet
