#include "cuda/emulated_runtime.hpp"

#include <cstdlib>
#include <cstring>
#include <deque>
#include <map>
#include <set>

#include "cuda/device_arena.hpp"

struct CUstream_st {
  std::deque<std::function<void()>> work;
};
struct CUgraph_st {
  std::deque<std::function<void(cudaStream_t)>> work;  ///< in order: each asks the stream for a piece
};
struct CUgraphExec_st : CUgraph_st {};
struct CUevent_st {
  CUstream_st* stream = nullptr;
  int ahead = 0;  ///< times it was recorded and not yet passed
  bool timed = false;
  double passed_ms = 0;
};

namespace facet {
namespace {

std::set<CUstream_st*>& streams() {
  static std::set<CUstream_st*> all;
  return all;
}

/// Where pinned host memory ends, by where it begins.
std::map<const char*, const char*>& pinned() {
  static std::map<const char*, const char*> all;
  return all;
}

void do_one(CUstream_st& stream) {
  const std::function<void()> work = std::move(stream.work.front());
  stream.work.pop_front();
  work();
}

template <class Condition>
void do_while(CUstream_st& stream, const Condition& condition) {
  if (stream.work.empty() || !condition()) return;
  ++emulated_runtime().waits;
  const DeviceArena::Access access;
  while (!stream.work.empty() && condition()) do_one(stream);
}

void do_everything() {
  for (CUstream_st* stream : streams()) do_while(*stream, [] { return true; });
}

template <class T>
T* made(T* thing) {
  ++emulated_runtime().made;
  ++emulated_runtime().living;
  return thing;
}

void enqueue(cudaStream_t stream, std::function<void()> work) {
  static std::mt19937 chance(5);
  stream->work.push_back(std::move(work));
  std::size_t count = 0;
  if (emulated_runtime().eagerness == Eagerness::random) count = chance() % 4;
  if (emulated_runtime().eagerness == Eagerness::at_once) count = stream->work.size();
  if (count == 0) return;
  const DeviceArena::Access access;
  for (; count > 0 && !stream->work.empty(); --count) do_one(*stream);
}

std::function<void()> bound(const void* kernel, dim3 blocks, dim3 threads, void** arguments) {
  return [work = static_cast<const EmulatedKernel*>(kernel)->bound(blocks, threads, arguments)] {
    work();
    emulated_runtime().now_ms += 1;
  };
}

std::function<void()> copying(void* to, const void* from, std::size_t bytes, cudaMemcpyKind kind) {
  return [=] {
    if (kind == cudaMemcpyHostToDevice) emulated_runtime().uploaded += bytes;
    std::memcpy(to, from, bytes);
  };
}

void record(cudaEvent_t event, cudaStream_t stream) {
  event->stream = stream;
  ++event->ahead;
  enqueue(stream, [event] {
    --event->ahead;
    event->passed_ms = emulated_runtime().now_ms;
  });
}

/// Graphs that are no chain are not emulated.
cudaError_t append(cudaGraphNode_t* node, cudaGraph_t graph, const cudaGraphNode_t* after, std::size_t count,
                   std::function<void(cudaStream_t)> piece) {
  const auto number = [](cudaGraphNode_t of) { return reinterpret_cast<std::uintptr_t>(of); };
  const bool continues =
      graph->work.empty() ? count == 0 : count == 1 && number(*after) == graph->work.size();
  if (!continues) return cudaErrorInvalidValue;
  graph->work.push_back(std::move(piece));
  *node = reinterpret_cast<cudaGraphNode_t>(graph->work.size());
  return cudaSuccess;
}

}  // namespace

bool device_may_use(const void* address) {
  const auto* byte = static_cast<const char*>(address);
  const auto after = pinned().upper_bound(byte);
  return DeviceArena::instance().contains(address) ||
         (after != pinned().begin() && byte < std::prev(after)->second);
}

EmulatedRuntime& emulated_runtime() {
  static EmulatedRuntime runtime;
  return runtime;
}

}  // namespace facet

using facet::emulated_runtime;

// Signatures and meaning are those of the CUDA runtime.
extern "C" {

cudaError_t cudaMalloc(void** data, size_t bytes) {
  if (bytes > emulated_runtime().memory_left) return cudaErrorMemoryAllocation;
  *data = facet::made(facet::DeviceArena::instance().allocate(bytes));
  return *data == nullptr ? cudaErrorMemoryAllocation : cudaSuccess;
}
cudaError_t cudaFree(void*) {
  facet::do_everything();
  --emulated_runtime().living;
  return cudaSuccess;
}
cudaError_t cudaHostAlloc(void** data, size_t bytes, unsigned) {
  *data = facet::made(std::malloc(bytes));
  facet::pinned()[static_cast<const char*>(*data)] = static_cast<const char*>(*data) + bytes;
  return cudaSuccess;
}
cudaError_t cudaFreeHost(void* data) {
  facet::do_everything();
  facet::pinned().erase(static_cast<const char*>(data));
  std::free(data);
  --emulated_runtime().living;
  return cudaSuccess;
}
cudaError_t cudaMemset(void* data, int value, size_t bytes) {  // does not wait for our streams
  const facet::DeviceArena::Access access;
  std::memset(data, value, bytes);
  return cudaSuccess;
}
cudaError_t cudaMemcpyAsync(void* to, const void* from, size_t bytes, cudaMemcpyKind kind,
                            cudaStream_t stream) {
  if (!facet::device_may_use(to) || !facet::device_may_use(from)) return cudaErrorInvalidValue;
  facet::enqueue(stream, facet::copying(to, from, bytes, kind));
  return cudaSuccess;
}
cudaError_t cudaLaunchKernel(const void* kernel, dim3 blocks, dim3 threads, void** arguments, size_t,
                             cudaStream_t stream) {
  ++emulated_runtime().launches;
  ++emulated_runtime().single_launches;
  facet::enqueue(stream, facet::bound(kernel, blocks, threads, arguments));
  return cudaSuccess;
}
cudaError_t cudaDeviceSynchronize() {
  facet::do_everything();
  return cudaSuccess;
}

cudaError_t cudaStreamCreateWithFlags(cudaStream_t* stream, unsigned) {
  facet::streams().insert(*stream = facet::made(new CUstream_st));
  return cudaSuccess;
}
cudaError_t cudaStreamDestroy(cudaStream_t stream) {
  facet::streams().erase(stream);
  delete stream;
  --emulated_runtime().living;
  return cudaSuccess;
}
cudaError_t cudaStreamSynchronize(cudaStream_t stream) {
  facet::do_while(*stream, [] { return true; });
  return cudaSuccess;
}

cudaError_t cudaEventCreateWithFlags(cudaEvent_t* event, unsigned flags) {
  *event = facet::made(new CUevent_st{nullptr, 0, (flags & cudaEventDisableTiming) == 0});
  return cudaSuccess;
}
cudaError_t cudaEventDestroy(cudaEvent_t event) {
  delete event;
  --emulated_runtime().living;
  return cudaSuccess;
}
cudaError_t cudaEventRecord(cudaEvent_t event, cudaStream_t stream) {
  facet::record(event, stream);
  return cudaSuccess;
}
cudaError_t cudaEventSynchronize(cudaEvent_t event) {
  if (event->stream != nullptr) facet::do_while(*event->stream, [event] { return event->ahead > 0; });
  return cudaSuccess;
}
cudaError_t cudaEventElapsedTime(float* ms, cudaEvent_t start, cudaEvent_t stop) {
  if (start->stream == nullptr || stop->stream == nullptr || !start->timed || !stop->timed)
    return cudaErrorInvalidResourceHandle;
  if (start->ahead > 0 || stop->ahead > 0) return cudaErrorNotReady;
  *ms = static_cast<float>(stop->passed_ms - start->passed_ms);
  return cudaSuccess;
}

cudaError_t cudaGraphCreate(cudaGraph_t* graph, unsigned) {
  *graph = facet::made(new CUgraph_st);
  return cudaSuccess;
}
cudaError_t cudaGraphDestroy(cudaGraph_t graph) {
  delete graph;
  --emulated_runtime().living;
  return cudaSuccess;
}
cudaError_t cudaGraphAddKernelNode(cudaGraphNode_t* node, cudaGraph_t graph, const cudaGraphNode_t* after,
                                   size_t count, const cudaKernelNodeParams* call) {
  const auto work = facet::bound(call->func, call->gridDim, call->blockDim, call->kernelParams);
  return facet::append(node, graph, after, count, [work](cudaStream_t stream) {
    ++emulated_runtime().launches;
    facet::enqueue(stream, work);
  });
}
cudaError_t cudaGraphAddMemcpyNode1D(cudaGraphNode_t* node, cudaGraph_t graph, const cudaGraphNode_t* after,
                                     size_t count, void* to, const void* from, size_t bytes,
                                     cudaMemcpyKind kind) {
  if (!facet::device_may_use(to) || !facet::device_may_use(from)) return cudaErrorInvalidValue;
  const auto work = facet::copying(to, from, bytes, kind);
  return facet::append(node, graph, after, count,
                       [work](cudaStream_t stream) { facet::enqueue(stream, work); });
}
cudaError_t cudaGraphAddEventRecordNode(cudaGraphNode_t* node, cudaGraph_t graph,
                                        const cudaGraphNode_t* after, size_t count, cudaEvent_t event) {
  return facet::append(node, graph, after, count,
                       [event](cudaStream_t stream) { facet::record(event, stream); });
}
cudaError_t cudaGraphInstantiate(cudaGraphExec_t* ready, cudaGraph_t graph, unsigned long long) {
  if (!emulated_runtime().takes_graphs) return cudaErrorNotSupported;
  *ready = facet::made(new CUgraphExec_st{*graph});
  return cudaSuccess;
}
cudaError_t cudaGraphLaunch(cudaGraphExec_t ready, cudaStream_t stream) {
  ++emulated_runtime().graphs;
  for (const auto& piece : ready->work) piece(stream);
  return cudaSuccess;
}
cudaError_t cudaGraphExecDestroy(cudaGraphExec_t ready) {
  delete ready;
  --emulated_runtime().living;
  return cudaSuccess;
}

cudaError_t cudaGetLastError() {
  return cudaSuccess;
}
const char* cudaGetErrorString(cudaError_t error) {
  return error == cudaErrorMemoryAllocation ? "out of memory" : "an error";
}
const char* cudaGetErrorName(cudaError_t error) {
  return error == cudaErrorMemoryAllocation ? "cudaErrorMemoryAllocation" : "cudaError";
}

}  // extern "C"
