#include "method/backend.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "cpu/cpu_pipeline.hpp"
#include "method/backend_agreement.hpp"
#include "support/expect_error.hpp"

namespace facet {
namespace {

TEST(Backend, TheCpuIsAlwaysThere) {
  EXPECT_EQ(choose_backend("cpu").backend, Backend::cpu);
  EXPECT_EQ(backend_name(Backend::cpu), "cpu");
  EXPECT_EQ(make_pipelines(Backend::cpu, 3, {}, 1, 1).size(), 3u);
}

TEST(Backend, AutoIsCudaWhereThatRunsAndElseTheCpuWithTheReason) {
  const BackendChoice choice = choose_backend("auto");
  const bool usable = cuda_support().unusable.empty();
  EXPECT_EQ(choice.backend, usable ? Backend::cuda : Backend::cpu);
  EXPECT_EQ(choice.reason, usable ? cuda_support().device : cuda_support().unusable);
}

TEST(Backend, CudaThatCannotRunIsAnErrorWithTheReason) {
  if (cuda_support().unusable.empty()) GTEST_SKIP() << "there is a device";
  expect_error(ErrorKind::not_measured, cuda_support().unusable, [] { choose_backend("cuda"); });
}

TEST(Backend, AnotherWordIsAnError) {
  expect_error(ErrorKind::usage, "'gpu' is not cpu, cuda or auto", [] { choose_backend("gpu"); });
}

TEST(BackendAgreement, APipelineAgreesWithItself) {
  EXPECT_TRUE(agree_on_test_frames(*make_cpu_pipeline({}, 1), *make_cpu_pipeline({}, 1, 3)));
}

/// Gives what another pipeline gives, but for one pixel, or one bit of one plane.
class AlmostRight final : public Pipeline {
 public:
  explicit AlmostRight(bool wrong_pixel) : wrong_pixel_(wrong_pixel) {}
  void run(StageRange stages, const FrameInput& frame, FrameResult& result) override {
    right_->run(stages, frame, result);
    if (wrong_pixel_)
      result.labels(80, 100) ^= 1;
    else
      for (Surface& surface : result.surfaces)
        if (surface.plane) surface.plane->d_m = std::nextafter(surface.plane->d_m, 10.0f);
  }
  void reset_history() override { right_->reset_history(); }

 private:
  std::unique_ptr<Pipeline> right_ = make_cpu_pipeline({}, 1);
  bool wrong_pixel_;
};

TEST(BackendAgreement, OnePixelOrOneBitOfAPlaneTellsThemApart) {
  for (const bool wrong_pixel : {true, false}) {
    AlmostRight almost(wrong_pixel);
    EXPECT_FALSE(agree_on_test_frames(*make_cpu_pipeline({}, 1), almost)) << wrong_pixel;
  }
}

}  // namespace
}  // namespace facet
