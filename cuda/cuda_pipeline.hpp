#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/host_threads.hpp"
#include "pipeline/pipeline.hpp"

namespace facet {

/// Version of nvcc that the program was built with; empty: it was built without CUDA.
std::string cuda_compiler();

/// What this machine has of CUDA.
struct CudaSupport {
  std::string unusable;  ///< why the pipeline cannot run on a device; empty where it can
  std::string driver;    ///< newest version of CUDA that the driver can serve; empty without a driver
  std::string device;    ///< name and compute capability of the first device; empty without one
};

/// Looks for a driver and a device, the first of those that CUDA_VISIBLE_DEVICES leaves, and tries it with a
/// kernel; never throws for want of one.
CudaSupport find_cuda_support();

using MakeHostThreads = std::function<std::unique_ptr<HostThreads>()>;

/// `count` pipelines on the CUDA device that take turns with the frames of one sequence, as
/// make_cpu_pipelines() makes them; each has a stream and buffers of its own. Their results are those of the
/// CPU to the bit. Stage times are taken on the device by events, totals by the clock, copies included.
/// `make_threads` gives each the threads that share its work on the host; without it, the calling one does
/// all. Throws Error{config} where a parameter is out of range, Error{not_measured} where there is no device
/// that could run them.
std::vector<std::unique_ptr<Pipeline>> make_cuda_pipelines(int count, const PipelineParams& params,
                                                           std::uint64_t seed,
                                                           const MakeHostThreads& make_threads = {});

}  // namespace facet
