#include "cuda/emulated_device.hpp"

#include <gtest/gtest.h>

#include "cpu/cpu_pipeline.hpp"
#include "cuda/three_frames.hpp"
#include "cuda/variants.hpp"
#include "pipeline/results.hpp"

namespace facet {
namespace {

TEST(DeviceArena, TheHostMustNotTouchTheMemoryOfTheDevice) {
  EmulatedDeviceImage<int> image;
  image.resize({3, 2});
  {
    const DeviceArena::Access access;
    image.view()(2, 1) = 7;
  }
  EXPECT_EQ(image.host_copy(0)(2, 1), 7);
  EXPECT_DEATH(image.view()(2, 1) = 8, "");
}

class EmulatedDevicePipeline : public testing::TestWithParam<Mode> {};

TEST_P(EmulatedDevicePipeline, GivesTheResultOfTheCpuAndLeavesDeviceMemoryToTheDevice) {
  constexpr Size size{101, 75};
  const FrameResult expected = last_of_three(size, *make_cpu_pipeline(GetParam().params, 7));
  for (const unsigned order : {1u, 2u}) {
    EmulatedDevice device(order);
    PipelineBody<EmulatedDevice> body(device, GetParam().params, 7);
    const FrameResult result =
        last_of_three(size, [&](const FrameInput& frame, FrameResult& out) { body.process(frame, out); });
    expect_equal_results(expected, result, GetParam().name);
  }
}

TEST_P(EmulatedDevicePipeline, FindsSurfacesInWhatIsCompared) {
  EXPECT_FALSE(last_of_three({101, 75}, *make_cpu_pipeline(GetParam().params, 7)).surfaces.empty());
}

INSTANTIATE_TEST_SUITE_P(EveryOperation, EmulatedDevicePipeline, testing::ValuesIn(every_operation()),
                         [](const auto& mode) { return std::string(mode.param.name); });

}  // namespace
}  // namespace facet
