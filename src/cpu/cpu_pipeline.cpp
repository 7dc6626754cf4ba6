#include "cpu/cpu_pipeline.hpp"

#include "cpu/executor.hpp"
#include "cpu/tuned/depth_jumps.hpp"
#include "cpu/tuned/fill_missing.hpp"
#include "cpu/tuned/hysteresis.hpp"
#include "cpu/tuned/labelling.hpp"
#include "cpu/tuned/morphology.hpp"
#include "cpu/tuned/normals.hpp"
#include "cpu/tuned/ownership.hpp"
#include "cpu/tuned/pruning.hpp"
#include "cpu/tuned/relocate.hpp"
#include "cpu/tuned/temporal_average.hpp"
#include "cpu/tuned/thinning.hpp"
#include "cpu/tuned/wiener.hpp"
#include "pipeline/frame_check.hpp"
#include "pipeline/pipeline_body.hpp"

namespace facet {
namespace {

class CpuPipeline final : public Pipeline {
 public:
  CpuPipeline(const PipelineParams& params, std::uint64_t seed, int threads)
      : executor_(threads), body_(executor_, params, seed) {}

  void process(const FrameInput& frame, FrameResult& result) override {
    check_frame(frame);
    body_.process(frame, result);
  }
  void reset_history() override { body_.reset_history(); }

 private:
  CpuExecutor executor_;
  PipelineBody<CpuExecutor> body_;
};

}  // namespace

std::unique_ptr<Pipeline> make_cpu_pipeline(const PipelineParams& params, std::uint64_t seed, int threads) {
  validate(params);
  return std::make_unique<CpuPipeline>(params, seed, threads);
}

}  // namespace facet
