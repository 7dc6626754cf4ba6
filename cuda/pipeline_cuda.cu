#include "core/error.hpp"
#include "cuda/cuda_floor.hpp"
#include "cuda/cuda_pipeline.hpp"
#include "cuda/executor.cuh"
#include "cuda/tuned/overloads.cuh"
#include "pipeline/frame_check.hpp"
#include "pipeline/pipeline_body.hpp"

namespace facet {
namespace {

void require_device() {
  if (const std::string unusable = find_cuda_support().unusable; !unusable.empty())
    throw Error(ErrorKind::not_measured, unusable);
}

class CudaPipeline final : public Pipeline {
 public:
  using History = PipelineBody<CudaExecutor>::History;

  CudaPipeline(const PipelineParams& params, std::uint64_t seed, std::unique_ptr<HostThreads> threads,
               std::shared_ptr<History> history)
      : executor_(std::move(threads)), body_(executor_, params, seed, std::move(history)) {}

  void run(StageRange stages, const FrameInput& frame, FrameResult& result) override {
    if (stages.contains(all_stages.first)) check_frame(frame);
    body_.run(stages, frame, result);
  }
  void reset_history() override { body_.reset_history(); }

 private:
  CudaExecutor executor_;
  PipelineBody<CudaExecutor> body_;
};

}  // namespace

std::vector<std::unique_ptr<Pipeline>> make_cuda_pipelines(int count, const PipelineParams& params,
                                                           std::uint64_t seed,
                                                           const MakeHostThreads& make_threads) {
  validate(params);
  require_device();
  const auto history = std::make_shared<CudaPipeline::History>();
  std::vector<std::unique_ptr<Pipeline>> pipelines;
  for (int i = 0; i < count; ++i) {
    auto threads = make_threads ? make_threads() : std::make_unique<HostThreads>();
    pipelines.push_back(std::make_unique<CudaPipeline>(params, seed, std::move(threads), history));
  }
  return pipelines;
}

std::array<int, stage_count> count_cuda_work(const PipelineParams& params, const FrameInput& frame) {
  validate(params);
  require_device();
  check_frame(frame);
  CudaExecutor executor;
  PipelineBody<CudaExecutor> body(executor, params, 1);
  FrameResult result;
  std::array<int, stage_count> pieces{};
  for (const StageName& stage : stage_names) {
    const std::uint64_t before = executor.work_given();
    body.run({stage.id, stage.id}, frame, result);
    pieces[static_cast<std::size_t>(index_of(stage.id))] = static_cast<int>(executor.work_given() - before);
  }
  return pieces;
}

}  // namespace facet
