// In place of all .cu files where the program is built without CUDA.

#include "core/error.hpp"
#include "cuda/cuda_floor.hpp"
#include "cuda/cuda_pipeline.hpp"

namespace facet {

std::string cuda_compiler() {
  return {};
}

CudaSupport find_cuda_support() {
  CudaSupport support;
  support.unusable = "this program was built without CUDA";
  return support;
}

std::vector<std::unique_ptr<Pipeline>> make_cuda_pipelines(int, const PipelineParams& params, std::uint64_t,
                                                           const MakeHostThreads&) {
  validate(params);
  throw Error(ErrorKind::not_measured, find_cuda_support().unusable);
}

CudaFloor measure_cuda_floor() {
  throw Error(ErrorKind::not_measured, find_cuda_support().unusable);
}

std::array<int, stage_count> count_cuda_work(const PipelineParams&, const FrameInput&) {
  throw Error(ErrorKind::not_measured, find_cuda_support().unusable);
}

}  // namespace facet
