#include <gtest/gtest.h>

#include "cpu/cpu_pipeline.hpp"
#include "cuda/counted_frame.hpp"
#include "cuda/device_arena.hpp"
#include "cuda/emulated_runtime.hpp"
#include "cuda/stream_executor.cuh"
#include "cuda/three_frames.hpp"
#include "cuda/tuned/overloads.cuh"
#include "cuda/variants.hpp"
#include "pipeline/results.hpp"
#include "support/expect_error.hpp"
#include "support/same_image.hpp"

namespace facet {
namespace {

/// The executor of the back end, its streams and copies included, on an emulated device.
using EmulatedExecutor = StreamExecutor<EmulatedKernels>;

constexpr Size size{101, 75};

class EmulatedDevice : public testing::Test {
 protected:
  void SetUp() override { emulated_runtime() = {}; }
};

TEST_F(EmulatedDevice, ItsMemoryIsNotForTheHost) {
  EmulatedExecutor executor;
  DeviceImage<int> image;
  image.resize({3, 2});
  executor.fill(image.view(), 7);
  EXPECT_EQ(executor.on_host(image)(2, 1), 7);
  EXPECT_DEATH(image.view()(2, 1) = 8, "");
}

TEST_F(EmulatedDevice, AnImageIsZeroAfterEachChangeOfItsSize) {
  EmulatedExecutor executor;
  DeviceImage<int> image;
  for (const Size some : {Size{9, 5}, Size{3, 2}, Size{40, 7}, Size{0, 0}, Size{4, 4}}) {
    image.resize(some);
    const ImageView<const int> host = executor.on_host(image);
    ASSERT_EQ(host.size(), some);
    for (int y = 0; y < some.height; ++y)
      for (int x = 0; x < some.width; ++x) EXPECT_EQ(host(x, y), 0);
    executor.fill(image.view(), 7);
  }
}

TEST_F(EmulatedDevice, ACopyForTheHostIsAsNewAsTheImage) {
  EmulatedExecutor executor;
  DeviceImage<std::uint16_t> image;
  image.resize({33, 9});
  for (const std::uint16_t value : std::array<std::uint16_t, 3>{3, 4, 5}) {
    executor.fill(image.view(), value);
    EXPECT_EQ(executor.on_host(image)(32, 8), value);
    EXPECT_EQ(executor.on_host(image)(0, 0), value);
  }
}

TEST_F(EmulatedDevice, WhatIsUploadedMayChangeAtOnceAndComesBackWhole) {
  EmulatedExecutor executor;
  DeviceImage<float> first, second;
  Image<float> host(Size{33, 9}), back(Size{33, 9});
  first.resize(host.size()), second.resize(host.size());  // which waits for the device
  for (DeviceImage<float>* image : {&first, &second}) {
    host.fill(image == &first ? 1.0f : 2.0f);
    executor.upload(std::as_const(host).view(), image->view());
  }
  executor.download(first.view(), back.view());
  EXPECT_EQ(back(32, 8), 1.0f);
  executor.download(second.view(), back.view());
  EXPECT_EQ(back(32, 8), 2.0f);
}

TEST_F(EmulatedDevice, AFrameInWholeUnitsTravelsInHalfTheBytes) {
  EmulatedExecutor executor;
  DeviceImage<float> image;
  image.resize({129, 509});
  const CountedFrame frame(image.size(), 0.0002, [](int x, int y) { return y * 129 + x; });
  upload_depth(executor, frame.depth_m.view(), frame.counts(), image.view());
  EXPECT_EQ(emulated_runtime().uploaded, 2u * 129 * 509);
  Image<float> back(image.size());
  executor.download(image.view(), back.view());
  EXPECT_TRUE(same_image(back, frame.depth_m));
  upload_depth(executor, frame.depth_m.view(), std::nullopt, image.view());
  EXPECT_EQ(emulated_runtime().uploaded, 6u * 129 * 509);
}

/// Counts down: `value` to 0, one per pass.
struct CountDownOp {
  static constexpr int radius = 0;
  ImageView<int> value;
  int* changed;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    if (value(x, y) == 0) return;
    --value(x, y);
    raise_flag(changed);
  }
};

TEST_F(EmulatedDevice, AnIteratedStageEndsAFewPassesAfterItsLastChange) {
  EmulatedExecutor executor;
  DeviceImage<int> image;
  image.resize({5, 3});
  for (const int count : {0, 1, 2, 7}) {
    executor.fill(image.view(), count);
    executor.take_changed();
    int passes = 0;
    do {
      executor.for_each_pixel(image.size(), CountDownOp{image.view(), executor.changed_flag()});
      ++passes;
    } while (executor.take_changed());
    EXPECT_EQ(executor.on_host(image)(4, 2), 0);
    EXPECT_EQ(passes, count + 1 + PassesAhead::count);
  }
}

TEST_F(EmulatedDevice, AStageThatIsStoppedEarlyDoesNotEndTheNextOne) {
  EmulatedExecutor executor;
  DeviceImage<int> image;
  image.resize({5, 3});
  for (const int limit : {1, 2, 3, 4, 5}) {
    for (const int most : {limit, 1000}) {
      executor.fill(image.view(), 4);
      executor.take_changed();
      for (int pass = 0; pass < most; ++pass) {
        executor.for_each_pixel(image.size(), CountDownOp{image.view(), executor.changed_flag()});
        if (!executor.take_changed()) break;
      }
      EXPECT_EQ(executor.on_host(image)(4, 2), std::max(0, 4 - most)) << limit;
    }
  }
}

TEST_F(EmulatedDevice, WithoutMemoryAnErrorSaysSo) {
  emulated_runtime().memory_left = 1000;
  EmulatedExecutor executor;
  DeviceImage<float> image;
  expect_error(ErrorKind::not_measured, "CUDA cannot allocate device memory: out of memory", [&] {
    image.resize({640, 480});
  });
}

TEST_F(EmulatedDevice, EverythingIsGivenBackAndNothingIsMadePerFrame) {
  {
    EmulatedExecutor executor;
    PipelineBody<EmulatedExecutor> body(executor, {}, 7);
    const Camera camera = scaled_camera(size);
    const Image<float> depth = small_measured_scene(4, size, camera, 1);
    FrameResult result;
    for (int frame = 0; frame < 6; ++frame) body.process({depth.view(), camera}, result);
    const int made = emulated_runtime().made;
    for (int frame = 0; frame < 3; ++frame) body.process({depth.view(), camera}, result);
    EXPECT_EQ(emulated_runtime().made, made);
    EXPECT_GT(emulated_runtime().living, 0);
  }
  EXPECT_EQ(emulated_runtime().living, 0);
}

TEST_F(EmulatedDevice, AFrameWaitsForTheDeviceALittleOftenerThanItHasPasses) {
  EmulatedExecutor executor;
  PipelineBody<EmulatedExecutor> body(executor, {}, 7);
  FrameResult result;
  last_of_three(size, [&](const FrameInput& frame, FrameResult& out) {
    emulated_runtime().waits = emulated_runtime().launches = 0;
    body.process(frame, out);
  });
  RecordProperty("waits", emulated_runtime().waits);
  RecordProperty("launches", emulated_runtime().launches);
  EXPECT_LT(emulated_runtime().waits, emulated_runtime().launches / 2);
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

TEST_F(EmulatedDevice, StagesAreTimedByEventsAndTheTotalByTheClock) {
  EmulatedExecutor executor;
  double total_ms = 0, stage_ms = 0, other_ms = 0;
  executor.timed(total_ms, [&] {
    executor.timed(stage_ms, [] {});
    executor.timed(other_ms, [] {});
    EXPECT_EQ(stage_ms, 0);
  });
  EXPECT_EQ(stage_ms, 1);  // what the emulated events say
  EXPECT_EQ(other_ms, 1);
  EXPECT_GT(total_ms, 0);
}

TEST_F(EmulatedDevice, AFrameThatFailedLeavesNothingToTheNext) {
  EmulatedExecutor executor;
  double total_ms = 0, lost_ms = 0, stage_ms = 0;
  EXPECT_THROW(executor.timed(total_ms,
                              [&] {
                                executor.timed(lost_ms, [] {});
                                throw Error(ErrorKind::data, "a broken frame");
                              }),
               Error);
  executor.timed(total_ms, [&] { executor.timed(stage_ms, [] {}); });
  EXPECT_EQ(lost_ms, 0);
  EXPECT_EQ(stage_ms, 1);
}

}  // namespace
}  // namespace facet
