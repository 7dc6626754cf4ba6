#include <gtest/gtest.h>

#include "cpu/cpu_pipeline.hpp"
#include "pipeline/modes.hpp"
#include "pipeline/pipeline_body.hpp"
#include "pipeline/results.hpp"
#include "pipeline/small_scene.hpp"
#include "support/shuffled_grid.hpp"

namespace facet {
namespace {

/// Awkward size: no multiple of a block or of a row's padding.
constexpr Size size{157, 119};

class BackendParity : public testing::TestWithParam<Mode> {
 protected:
  Camera camera = scaled_camera(size);
  /// The same three frames for everyone: the temporal average sees a past.
  template <class Process>
  FrameResult last_of_three(const Process& process) {
    FrameResult result;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const Image<float> depth = small_measured_scene(4, size, camera, seed);
      process(FrameInput{depth.view(), camera}, result);
    }
    return result;
  }
  FrameResult on_cpu(int threads) {
    const auto pipeline = make_cpu_pipeline(GetParam().params, 7, threads);
    return last_of_three(
        [&](const FrameInput& frame, FrameResult& result) { pipeline->process(frame, result); });
  }
  FrameResult on_grid(unsigned order) {
    ShuffledGridExecutor executor(order);
    PipelineBody<ShuffledGridExecutor> body(executor, GetParam().params, 7);
    return last_of_three([&](const FrameInput& frame, FrameResult& result) { body.process(frame, result); });
  }
};

TEST_P(BackendParity, ThreadsDoNotChangeTheResult) {
  expect_equal_results(on_cpu(1), on_cpu(3), GetParam().name);
}

TEST_P(BackendParity, AShuffledGridOfThreadsGivesTheResultOfTheCpu) {
  const FrameResult reference = on_cpu(1);
  for (const unsigned order : {1u, 2u}) expect_equal_results(reference, on_grid(order), GetParam().name);
}

TEST_P(BackendParity, TheComparedFrameIsNotEmpty) {
  const FrameResult result = on_cpu(1);
  EXPECT_GT(result.surfaces.size(), 2u);
}

INSTANTIATE_TEST_SUITE_P(Modes, BackendParity, testing::ValuesIn(modes),
                         [](const auto& mode) { return std::string(mode.param.name); });

}  // namespace
}  // namespace facet
