#include <gtest/gtest.h>
#include <thread>

#include "core/error.hpp"
#include "cpu/cpu_pipeline.hpp"
#include "cuda/counted_frame.hpp"
#include "cuda/device_test.hpp"
#include "cuda/three_frames.hpp"
#include "cuda/variants.hpp"
#include "pipeline/results.hpp"

namespace facet {
namespace {

std::unique_ptr<Pipeline> make_cuda_pipeline(const PipelineParams& params) {
  return std::move(make_cuda_pipelines(1, params, 7).front());
}

class CudaParity : public DeviceTest<testing::TestWithParam<Mode>> {
 protected:
  const PipelineParams& params() const { return GetParam().params; }
};

TEST_P(CudaParity, GivesTheResultOfTheCpuOnAnOddSize) {
  constexpr Size size{157, 119};
  expect_equal_results(last_of_three(size, *make_cpu_pipeline(params(), 7)),
                       last_of_three(size, *make_cuda_pipeline(params())), GetParam().name);
}

TEST_P(CudaParity, GivesTheResultOfTheCpuOnTheFrameOfASensor) {
  constexpr Size size{640, 480};
  expect_equal_results(last_of_three(size, *make_cpu_pipeline(params(), 7)),
                       last_of_three(size, *make_cuda_pipeline(params())), GetParam().name);
}

TEST_P(CudaParity, GivesTheResultOfTheCpuInARunningSequence) {  // whose work comes again, as graphs
  constexpr Size size{157, 119};
  const Camera camera = scaled_camera(size);
  const auto cpu = make_cpu_pipeline(params(), 7), cuda = make_cuda_pipeline(params());
  FrameResult expected, result;
  for (std::uint64_t i = 0; i < 20; ++i) {
    const Image<float> depth = small_measured_scene(4, size, camera, i % 2);
    cpu->process({depth.view(), camera}, expected);
    cuda->process({depth.view(), camera}, result);
    expect_equal_results(expected, result, "frame " + std::to_string(i));
  }
}

TEST_P(CudaParity, GivesTheResultOfTheCpuOnAwkwardFramesOneAfterTheOther) {
  const auto cpu = make_cpu_pipeline(params(), 7), cuda = make_cuda_pipeline(params());
  for (const Size size : {Size{1, 1}, Size{31, 7}, Size{33, 9}, Size{1, 40}, Size{97, 61}, Size{31, 7}}) {
    const Camera camera = scaled_camera(size);
    for (const Image<float>& depth :
         {small_measured_scene(1, size, camera, 1), Image<float>(size, 0.0f), Image<float>(size, 1.0f)}) {
      FrameResult expected, result;
      cpu->process({depth.view(), camera}, expected);
      cuda->process({depth.view(), camera}, result);
      expect_equal_results(expected, result, std::to_string(size.width) + "x" + std::to_string(size.height));
    }
  }
}

TEST_P(CudaParity, GivesTheSameTwentyTimes) {
  constexpr Size size{321, 243};
  const auto cuda = make_cuda_pipeline(params());
  const FrameResult first = last_of_three(size, *cuda);
  for (int i = 1; i < 20; ++i) {
    cuda->reset_history();
    expect_equal_results(first, last_of_three(size, *cuda), GetParam().name);
  }
}

INSTANTIATE_TEST_SUITE_P(EveryOperation, CudaParity, testing::ValuesIn(every_operation()),
                         [](const auto& mode) { return std::string(mode.param.name); });

using CudaPipelines = DeviceTest<>;

TEST_F(CudaPipelines, ThatTakeTurnsAndRunInPartsGiveWhatTheCpuGives) {
  constexpr Size size{160, 120};
  const Camera camera = scaled_camera(size);
  const auto alone = make_cpu_pipeline({}, 7);
  const auto turns = make_cuda_pipelines(2, {}, 7);
  FrameResult expected, results[2];
  for (std::size_t i = 0; i < 8; ++i) {
    const Image<float> depth = small_measured_scene(1, size, camera, i);
    const FrameInput frame{depth.view(), camera};
    alone->process(frame, expected);
    for (const StageRange part : {StageRange{StageId::temporal, StageId::wiener},
                                  {StageId::gradient, StageId::validation},
                                  {StageId::pose, StageId::objects}})
      std::thread([&] { turns[i % 2]->run(part, frame, results[i % 2]); }).join();
    expect_equal_results(expected, results[i % 2], "frame " + std::to_string(i));
  }
}

TEST_F(CudaPipelines, MakeTheMetresOfEveryCountThatTheCpuMakes) {
  PipelineParams p;
  p.temporal.enabled = p.wiener.enabled = false;
  for (const double unit_m : {0.001, 0.0002, 0.000125, 1.0 / 3}) {
    const CountedFrame frame({256, 256}, unit_m, [](int x, int y) { return 256 * y + x; });
    const Camera camera = scaled_camera(frame.depth_m.size());
    FrameResult expected, result;
    make_cpu_pipeline(p, 7)->process({frame.depth_m.view(), camera}, expected);
    make_cuda_pipeline(p)->process({frame.depth_m.view(), camera, {}, {}, frame.counts()}, result);
    expect_equal_results(expected, result, std::to_string(unit_m));
  }
}

TEST_F(CudaPipelines, BesideEachOtherGiveWhatTheCpuGives) {
  constexpr Size size{321, 243};
  const FrameResult expected = last_of_three(size, *make_cpu_pipeline({}, 7));
  std::vector<FrameResult> results(8);
  std::vector<std::thread> threads;
  for (FrameResult& result : results)
    threads.emplace_back([&] { result = last_of_three(size, *make_cuda_pipeline({})); });
  for (std::thread& thread : threads) thread.join();
  for (const FrameResult& result : results) expect_equal_results(expected, result, "in parallel");
}

TEST_F(CudaPipelines, TimeEveryStageAndTheTotal) {
  const FrameResult result = last_of_three({640, 480}, *make_cuda_pipeline({}));
  for (const StageId id : {StageId::temporal, StageId::fill, StageId::wiener, StageId::depth_strength,
                           StageId::crease_strength, StageId::labelling})
    EXPECT_GT(result.times.stage_ms[static_cast<std::size_t>(index_of(id))], 0)
        << stage_names[static_cast<std::size_t>(index_of(id))].key;
  EXPECT_GT(result.times.total_ms, 0);
}

TEST_F(CudaPipelines, RefuseAFrameThatCannotBe) {
  Image<float> depth(Size{8, 8}, -1.0f);
  FrameResult result;
  EXPECT_THROW(make_cuda_pipeline({})->process({depth.view(), {8, 8, 4, 4}}, result), Error);
}

}  // namespace
}  // namespace facet
