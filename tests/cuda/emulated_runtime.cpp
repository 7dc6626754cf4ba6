#include "cuda/emulated_runtime.hpp"

#include <cstdlib>
#include <cstring>
#include <deque>
#include <set>

#include "cuda/device_arena.hpp"

struct CUstream_st {
  std::deque<std::function<void()>> work;
};
struct CUevent_st {
  CUstream_st* stream = nullptr;
  int ahead = 0;  ///< times it was recorded and not yet passed
  bool timed = false;
};

namespace facet {
namespace {

std::set<CUstream_st*>& streams() {
  static std::set<CUstream_st*> all;
  return all;
}

void do_one(CUstream_st& stream) {
  const DeviceArena::Access access;
  const std::function<void()> work = std::move(stream.work.front());
  stream.work.pop_front();
  work();
}

template <class Condition>
void do_while(CUstream_st& stream, const Condition& condition) {
  if (!stream.work.empty() && condition()) ++emulated_runtime().waits;
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

}  // namespace

EmulatedRuntime& emulated_runtime() {
  static EmulatedRuntime runtime;
  return runtime;
}

void enqueue(cudaStream_t stream, std::function<void()> work) {
  static std::mt19937 chance(5);
  stream->work.push_back(std::move(work));
  if (emulated_runtime().eagerness == Eagerness::late) return;
  for (auto count = chance() % 4; count > 0 && !stream->work.empty(); --count) do_one(*stream);
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
  return cudaSuccess;
}
cudaError_t cudaFreeHost(void* data) {
  facet::do_everything();
  std::free(data);
  --emulated_runtime().living;
  return cudaSuccess;
}
cudaError_t cudaMemset(void* data, int value, size_t bytes) {  // does not wait for our streams
  const facet::DeviceArena::Access access;
  std::memset(data, value, bytes);
  return cudaSuccess;
}
cudaError_t cudaMemsetAsync(void* data, int value, size_t bytes, cudaStream_t stream) {
  facet::enqueue(stream, [=] { std::memset(data, value, bytes); });
  return cudaSuccess;
}
cudaError_t cudaMemcpyAsync(void* to, const void* from, size_t bytes, cudaMemcpyKind, cudaStream_t stream) {
  facet::enqueue(stream, [=] { std::memcpy(to, from, bytes); });
  return cudaSuccess;
}
cudaError_t cudaMemcpy2DAsync(void* to, size_t to_pitch, const void* from, size_t from_pitch, size_t width,
                              size_t height, cudaMemcpyKind kind, cudaStream_t stream) {
  if (width > to_pitch || width > from_pitch) return cudaErrorInvalidPitchValue;
  if (kind == cudaMemcpyHostToDevice) emulated_runtime().uploaded += width * height;
  facet::enqueue(stream, [=] {
    for (size_t y = 0; y < height; ++y)
      std::memcpy(static_cast<char*>(to) + y * to_pitch, static_cast<const char*>(from) + y * from_pitch,
                  width);
  });
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
  event->stream = stream;
  ++event->ahead;
  facet::enqueue(stream, [event] { --event->ahead; });
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
  *ms = 1;
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
