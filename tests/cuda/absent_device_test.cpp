#include <cstdlib>
#include <gtest/gtest.h>

#include "cuda/cuda_pipeline.hpp"
#include "support/expect_error.hpp"

namespace facet {
namespace {

/// The program sees no device, whatever the machine has.
class AbsentDevice : public testing::Test {
 protected:
  static void SetUpTestSuite() { ::setenv("CUDA_VISIBLE_DEVICES", "", 1); }
};

TEST_F(AbsentDevice, IsToldInWords) {
  const CudaSupport support = find_cuda_support();
  EXPECT_NE(support.unusable, "");
  EXPECT_EQ(support.device, "");
}

TEST_F(AbsentDevice, MakesNoPipeline) {
  expect_error(ErrorKind::not_measured, find_cuda_support().unusable, [] { make_cuda_pipelines(1, {}, 1); });
}

TEST_F(AbsentDevice, DoesNotHideThatAParameterIsWrong) {
  PipelineParams params;
  params.wiener.window_px = 4;
  expect_error(ErrorKind::config, "wiener.window_px", [&] { make_cuda_pipelines(1, params, 1); });
}

}  // namespace
}  // namespace facet
