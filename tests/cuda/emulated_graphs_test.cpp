#include <algorithm>

#include "cpu/cpu_pipeline.hpp"
#include "cuda/emulated_device.hpp"
#include "cuda/variants.hpp"
#include "pipeline/pipeline_body.hpp"
#include "pipeline/results.hpp"
#include "pipeline/small_scene.hpp"

namespace facet {
namespace {

constexpr Size size = emulated_size;

/// What lay on the stack before pads the arguments of kernels.
[[gnu::noinline]] void scribble_on_stack(int value) {
  volatile unsigned char scribble[1 << 16];
  for (volatile unsigned char& byte : scribble) byte = static_cast<unsigned char>(value);
}

class EmulatedSequence : public testing::TestWithParam<Mode> {};

TEST_P(EmulatedSequence, IsGivenToTheDeviceInGraphsAlone) {
  emulated_runtime() = {};
  EmulatedExecutor executor;
  PipelineBody<EmulatedExecutor> body(executor, GetParam().params, 7);
  const Camera camera = scaled_camera(size);
  const Image<float> depth = small_measured_scene(4, size, camera, 1);
  FrameResult result;
  int fewest_single = 1000;
  // How many passes hysteresis needs depends on the order of threads: a frame may need a number that is new.
  for (int frame = 0; frame < frames_until_steady + 10; ++frame) {
    scribble_on_stack(frame);
    emulated_runtime().launches = emulated_runtime().single_launches = emulated_runtime().graphs = 0;
    body.process({depth.view(), camera}, result);
    fewest_single = std::min(fewest_single, emulated_runtime().single_launches);
  }
  RecordProperty("launches", emulated_runtime().launches);
  RecordProperty("graphs", emulated_runtime().graphs);
  EXPECT_GT(emulated_runtime().launches, 5 * emulated_runtime().graphs);
  EXPECT_EQ(fewest_single, 0);
}

INSTANTIATE_TEST_SUITE_P(EveryOperation, EmulatedSequence, testing::ValuesIn(every_operation()),
                         [](const auto& mode) { return std::string(mode.param.name); });

TEST_F(EmulatedDevice, TakesNoGraphForOtherWork) {
  EmulatedExecutor executor;
  DeviceImage<int> image, other;
  image.resize({33, 9}), other.resize({31, 9});
  for (const int value : {1, 1, 1, 2, 1, 2, 2, 3}) {  // again and again, and with another number
    executor.fill(image.view(), value);
    executor.copy(std::as_const(image).view(), image.view());
    EXPECT_EQ(executor.on_host(image)(32, 8), value);
    executor.fill(other.view(), value);  // in other memory, and of another size
    executor.copy(std::as_const(other).view(), other.view());
    EXPECT_EQ(executor.on_host(other)(30, 8), value);
  }
  EXPECT_GT(emulated_runtime().graphs, 0);
}

TEST_F(EmulatedDevice, ForgetsGraphsWhenThereAreTooMany) {
  EmulatedExecutor executor;
  DeviceImage<int> image;
  image.resize({3, 2});
  const auto fill_twice = [&](int value) {
    executor.fill(image.view(), -1);
    executor.fill(image.view(), value);
    return executor.on_host(image)(2, 1);
  };
  for (int value = 0; value < 2 * static_cast<int>(GraphCache::most_lists); ++value)
    for (int again = 0; again < 2; ++again) EXPECT_EQ(fill_twice(value), value);
  EXPECT_LE(emulated_runtime().living, 2 * static_cast<int>(GraphCache::most_lists));
}

TEST_F(EmulatedDevice, ThatTakesNoGraphsWorksWithoutThem) {
  emulated_runtime().takes_graphs = false;
  const Camera camera = scaled_camera(size);
  const auto cpu = make_cpu_pipeline({}, 7);
  EmulatedExecutor executor;
  PipelineBody<EmulatedExecutor> body(executor, {}, 7);
  FrameResult expected, result;
  for (std::uint64_t i = 0; i < 7; ++i) {
    const Image<float> depth = small_measured_scene(4, size, camera, i);
    cpu->process({depth.view(), camera}, expected);
    body.process({depth.view(), camera}, result);
    expect_equal_results(expected, result, "frame " + std::to_string(i));
  }
  EXPECT_EQ(emulated_runtime().graphs, 0);
}

}  // namespace
}  // namespace facet
