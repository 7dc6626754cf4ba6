#include "cpu/cpu_pipeline.hpp"
#include "cuda/counted_frame.hpp"
#include "cuda/emulated_device.hpp"
#include "cuda/three_frames.hpp"
#include "cuda/variants.hpp"
#include "pipeline/results.hpp"

namespace facet {
namespace {

constexpr Size size = emulated_size;

TEST_F(EmulatedDevice, EverythingIsGivenBackAndNothingIsMadePerFrame) {
  {
    EmulatedExecutor executor;
    PipelineBody<EmulatedExecutor> body(executor, {}, 7);
    const Camera camera = scaled_camera(size);
    const Image<float> depth = small_measured_scene(4, size, camera, 1);
    FrameResult result;
    for (int frame = 0; frame < frames_until_steady; ++frame) body.process({depth.view(), camera}, result);
    const int made = emulated_runtime().made;
    for (int frame = 0; frame < 3; ++frame) body.process({depth.view(), camera}, result);
    EXPECT_EQ(emulated_runtime().made, made);
    EXPECT_GT(emulated_runtime().living, 0);
  }
  EXPECT_EQ(emulated_runtime().living, 0);
}

TEST_F(EmulatedDevice, IsWaitedForRarelyInARunningSequence) {
  EmulatedExecutor executor;
  PipelineBody<EmulatedExecutor> body(executor, {}, 7);
  FrameResult result;
  last_of_three(size, [&](const FrameInput& frame, FrameResult& out) {
    emulated_runtime().waits = emulated_runtime().launches = 0;
    body.process(frame, out);
  });
  RecordProperty("waits", emulated_runtime().waits);
  RecordProperty("launches", emulated_runtime().launches);
  EXPECT_LT(emulated_runtime().waits, emulated_runtime().launches / 5);
}

TEST_F(EmulatedDevice, FramesOfManySizesOneAfterTheOtherGiveWhatTheCpuGives) {
  const auto cpu = make_cpu_pipeline({}, 7);
  EmulatedExecutor executor;
  PipelineBody<EmulatedExecutor> body(executor, {}, 7);
  FrameResult expected, result;
  for (int round = 0; round < 4; ++round)
    for (const Size some : {size, Size{64, 48}, Size{31, 7}, size, size}) {
      const Camera camera = scaled_camera(some);
      const Image<float> depth = small_measured_scene(4, some, camera, 1);
      cpu->process({depth.view(), camera}, expected);
      body.process({depth.view(), camera}, result);
      expect_equal_results(expected, result, std::to_string(round) + ": " + std::to_string(some.width));
    }
  EXPECT_GT(emulated_runtime().graphs, 0);
}

class EmulatedPipeline : public testing::TestWithParam<Mode> {};

TEST_P(EmulatedPipeline, GivesTheResultOfTheCpuHoweverLateTheDeviceWorks) {
  const FrameResult expected = last_of_three(size, *make_cpu_pipeline(GetParam().params, 7));
  EXPECT_FALSE(expected.surfaces.empty());
  for (const Eagerness eagerness : {Eagerness::late, Eagerness::random}) {
    emulated_runtime() = {};
    emulated_runtime().eagerness = eagerness;
    EmulatedExecutor executor;
    PipelineBody<EmulatedExecutor> body(executor, GetParam().params, 7);
    const FrameResult result =
        last_of_three(size, [&](const FrameInput& frame, FrameResult& out) { body.process(frame, out); });
    expect_equal_results(expected, result, GetParam().name);
  }
}

TEST_P(EmulatedPipeline, GivesTheResultOfTheCpuInARunningSequence) {
  emulated_runtime() = {};
  const auto cpu = make_cpu_pipeline(GetParam().params, 7);
  EmulatedExecutor executor(make_host_threads(3));
  PipelineBody<EmulatedExecutor> body(executor, GetParam().params, 7);
  const Camera camera = scaled_camera(size);
  FrameResult expected, result;
  for (int i = 0; i < frames_until_steady + 2; ++i) {
    const Image<float> depth = small_measured_scene(4, size, camera, static_cast<std::uint64_t>(i) % 2);
    cpu->process({depth.view(), camera}, expected);
    body.process({depth.view(), camera}, result);
    expect_equal_results(expected, result, "frame " + std::to_string(i));
  }
  EXPECT_GT(emulated_runtime().graphs, 0);
}

INSTANTIATE_TEST_SUITE_P(EveryOperation, EmulatedPipeline, testing::ValuesIn(every_operation()),
                         [](const auto& mode) { return std::string(mode.param.name); });

TEST_F(EmulatedDevice, FramesInWholeUnitsAndOthersMakeOneSequence) {
  const auto cpu = make_cpu_pipeline({}, 7);
  EmulatedExecutor executor;
  PipelineBody<EmulatedExecutor> body(executor, {}, 7);
  const Camera camera = scaled_camera(size);
  FrameResult expected, result;
  for (std::uint64_t i = 0; i < 4; ++i) {
    const Image<float> scene = small_measured_scene(4, size, camera, i);
    const CountedFrame frame(size, 0.001, [&](int x, int y) { return scene(x, y) * 1000; });
    cpu->process({frame.depth_m.view(), camera}, expected);
    body.process({frame.depth_m.view(), camera, {}, {}, i == 2 ? std::nullopt : frame.counts()}, result);
    expect_equal_results(expected, result, "frame " + std::to_string(i));
  }
}

TEST_F(EmulatedDevice, BodiesThatTakeTurnsInPartsShareTheirPast) {
  const Camera camera = scaled_camera(size);
  const auto cpu = make_cpu_pipeline({}, 7);
  const auto history = std::make_shared<PipelineBody<EmulatedExecutor>::History>();
  EmulatedExecutor executors[2];
  PipelineBody<EmulatedExecutor> bodies[2]{{executors[0], {}, 7, history}, {executors[1], {}, 7, history}};
  FrameResult expected, results[2];
  for (std::size_t i = 0; i < 4; ++i) {
    const Image<float> depth = small_measured_scene(1, size, camera, i);
    cpu->process({depth.view(), camera}, expected);
    for (const StageRange part :
         {StageRange{StageId::temporal, StageId::wiener}, {StageId::gradient, StageId::objects}})
      bodies[i % 2].run(part, {depth.view(), camera}, results[i % 2]);
    expect_equal_results(expected, results[i % 2], "frame " + std::to_string(i));
  }
}

}  // namespace
}  // namespace facet
