#include "method/backend.hpp"

#include "core/error.hpp"
#include "cpu/cpu_pipeline.hpp"
#include "method/backend_agreement.hpp"

namespace facet {

std::string_view backend_name(Backend backend) {
  return backend == Backend::cuda ? "cuda" : "cpu";
}

namespace {

/// A device that gives other results than the CPU is as good as none.
CudaSupport find_trusted_support() {
  CudaSupport support = find_cuda_support();
  if (!support.unusable.empty()) return support;
  try {
    if (!agree_on_test_frames(*make_cpu_pipeline({}, 1), *make_cuda_pipelines(1, {}, 1).front()))
      support.unusable = support.device + " does not give the results of the CPU";
  } catch (const Error& e) {
    support.unusable = support.device + ": " + e.what();
  }
  return support;
}

}  // namespace

const CudaSupport& cuda_support() {
  static const CudaSupport support = find_trusted_support();  // takes a while where there is a device
  return support;
}

BackendChoice choose_backend(std::string_view asked) {
  if (asked == "cpu") return {Backend::cpu, "as asked"};
  if (asked != "cuda" && asked != "auto")
    throw Error(ErrorKind::usage, "--backend: '" + std::string(asked) + "' is not cpu, cuda or auto");
  const CudaSupport& cuda = cuda_support();
  if (cuda.unusable.empty()) return {Backend::cuda, cuda.device};
  if (asked == "auto") return {Backend::cpu, cuda.unusable};
  throw Error(ErrorKind::not_measured, "--backend cuda: " + cuda.unusable + "; use cpu or auto");
}

std::vector<std::unique_ptr<Pipeline>> make_pipelines(Backend backend, int count,
                                                      const PipelineParams& params, std::uint64_t seed,
                                                      int threads) {
  if (backend == Backend::cpu) return make_cpu_pipelines(count, params, seed, threads);
  return make_cuda_pipelines(count, params, seed, [threads] { return make_host_threads(threads); });
}

}  // namespace facet
