#include "cpu/cpu_pipeline.hpp"

#include "cpu/executor.hpp"
#include "cpu/tuned/basins.hpp"
#include "cpu/tuned/crease_by_normals.hpp"
#include "cpu/tuned/depth_jumps.hpp"
#include "cpu/tuned/edge_distance.hpp"
#include "cpu/tuned/edge_kind.hpp"
#include "cpu/tuned/fill_missing.hpp"
#include "cpu/tuned/hysteresis.hpp"
#include "cpu/tuned/labelling.hpp"
#include "cpu/tuned/morphology.hpp"
#include "cpu/tuned/number_regions.hpp"
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
  using History = PipelineBody<CpuExecutor>::History;

  CpuPipeline(const PipelineParams& params, std::uint64_t seed, int threads, std::shared_ptr<History> history)
      : executor_(threads), body_(executor_, params, seed, std::move(history)) {}

  void run(StageRange stages, const FrameInput& frame, FrameResult& result) override {
    if (stages.contains(all_stages.first)) check_frame(frame);
    body_.run(stages, frame, result);
  }
  void reset_history() override { body_.reset_history(); }

 private:
  CpuExecutor executor_;
  PipelineBody<CpuExecutor> body_;
};

}  // namespace

std::unique_ptr<Pipeline> make_cpu_pipeline(const PipelineParams& params, std::uint64_t seed, int threads) {
  return std::move(make_cpu_pipelines(1, params, seed, threads).front());
}

std::vector<std::unique_ptr<Pipeline>> make_cpu_pipelines(int count, const PipelineParams& params,
                                                          std::uint64_t seed, int threads) {
  validate(params);
  const auto history = std::make_shared<CpuPipeline::History>();
  std::vector<std::unique_ptr<Pipeline>> pipelines;
  for (int i = 0; i < count; ++i)
    pipelines.push_back(std::make_unique<CpuPipeline>(params, seed, threads, history));
  return pipelines;
}

std::unique_ptr<HostThreads> make_host_threads(int threads) {
  return std::make_unique<CpuExecutor>(threads);
}

}  // namespace facet
