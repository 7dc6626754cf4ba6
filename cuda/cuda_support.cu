#include <cuda_runtime.h>

#include "cuda/cuda_pipeline.hpp"

namespace facet {
namespace {

__global__ void probe_kernel() {}

std::string version_text(int version) {
  return std::to_string(version / 1000) + '.' + std::to_string(version % 1000 / 10);
}

/// Whether the device runs what this program holds; a program has code for some kinds of devices only.
std::string why_no_kernel_runs(const std::string& device) {
  probe_kernel<<<1, 1>>>();
  cudaError_t status = cudaGetLastError();
  if (status == cudaSuccess) status = cudaDeviceSynchronize();
  if (status == cudaSuccess) return {};
  static_cast<void>(cudaGetLastError());
  return device + " cannot run this program's kernels: " + cudaGetErrorString(status);
}

}  // namespace

std::string cuda_compiler() {
  return std::to_string(__CUDACC_VER_MAJOR__) + '.' + std::to_string(__CUDACC_VER_MINOR__);
}

CudaSupport find_cuda_support() {
  CudaSupport support;
  int driver = 0, devices = 0;
  if (cudaDriverGetVersion(&driver) == cudaSuccess && driver > 0) support.driver = version_text(driver);
  const cudaError_t status = cudaGetDeviceCount(&devices);
  if (status != cudaSuccess || devices == 0) {
    static_cast<void>(cudaGetLastError());
    support.unusable = support.driver.empty() ? "there is no NVIDIA driver"
                       : status == cudaSuccess
                           ? "there is no CUDA device"
                           : std::string("there is no CUDA device: ") + cudaGetErrorString(status);
    return support;
  }
  cudaDeviceProp device{};
  if (const cudaError_t unreadable = cudaGetDeviceProperties(&device, 0); unreadable != cudaSuccess) {
    support.unusable = std::string("the CUDA device does not answer: ") + cudaGetErrorString(unreadable);
    return support;
  }
  support.device = std::string(device.name) + ", compute capability " + std::to_string(device.major) + '.' +
                   std::to_string(device.minor);
  support.unusable = why_no_kernel_runs(support.device);
  return support;
}

}  // namespace facet
