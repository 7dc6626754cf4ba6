#include <algorithm>
#include <chrono>

#include "cuda/cuda_floor.hpp"
#include "cuda/cuda_pipeline.hpp"
#include "cuda/graph.cuh"
#include "cuda/memory.cuh"
#include "cuda/stream.cuh"

namespace facet {
namespace {

constexpr std::size_t copied_bytes = std::size_t{256} << 20;
constexpr int copies = 10, launches = 1000;

__global__ void empty_kernel() {}

/// Least of five times [ms] that `work` takes on the device.
template <class Work>
double least_ms(const Stream& stream, const Work& work) {
  Event start(Event::Kind::timed), stop(Event::Kind::timed);
  double least = 1e30;
  for (int i = 0; i < 5; ++i) {
    check_cuda(cudaEventRecord(start.handle(), stream), "record an event");
    work();
    check_cuda(cudaEventRecord(stop.handle(), stream), "record an event");
    stop.wait();
    least = std::min(least, stop.ms_since(start));
  }
  return least;
}

double copy_rate(const Stream& stream, void* to, const void* from, cudaMemcpyKind kind) {
  const double ms = least_ms(stream, [&] {
    for (int i = 0; i < copies; ++i)
      check_cuda(cudaMemcpyAsync(to, from, copied_bytes, kind, stream), "copy memory");
  });
  return static_cast<double>(copied_bytes) * copies / (ms / 1000);
}

/// Of a graph, or else of single launches.
double launch_us(const Stream& stream) {
  WorkList list;
  for (int i = 0; i < launches; ++i) list.call(reinterpret_cast<const void*>(&empty_kernel), 1, 1);
  const std::optional<Graph> graph = Graph::of(list);
  const double ms = least_ms(stream, [&] {
    if (graph) return graph->launch(stream);
    for (int i = 0; i < launches; ++i) empty_kernel<<<1, 1, 0, stream>>>();
    check_cuda(cudaGetLastError(), "launch a kernel");
  });
  return ms * 1000 / launches;
}

double round_trip_us(const Stream& stream) {
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < launches; ++i) {
    empty_kernel<<<1, 1, 0, stream>>>();
    stream.wait();
  }
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count() /
         launches;
}

}  // namespace

CudaFloor measure_cuda_floor() {
  if (const std::string unusable = find_cuda_support().unusable; !unusable.empty())
    throw Error(ErrorKind::not_measured, unusable);
  const Stream stream;
  DeviceMemory from, to;
  PinnedMemory host;
  from.reserve(copied_bytes);
  to.reserve(copied_bytes);
  host.reserve(copied_bytes);
  CudaFloor floor;
  floor.copy_bytes_per_s = 2 * copy_rate(stream, to.as<void>(), from.as<void>(), cudaMemcpyDeviceToDevice);
  floor.upload_bytes_per_s = copy_rate(stream, to.as<void>(), host.as<void>(), cudaMemcpyHostToDevice);
  floor.download_bytes_per_s = copy_rate(stream, host.as<void>(), from.as<void>(), cudaMemcpyDeviceToHost);
  floor.launch_us = launch_us(stream);
  floor.round_trip_us = round_trip_us(stream);
  return floor;
}

}  // namespace facet
