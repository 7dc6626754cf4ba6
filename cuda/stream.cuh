#pragma once

#include <utility>

#include "cuda/error.cuh"

namespace facet {

/// A queue of work for the device, beside those of other executors.
class Stream {
 public:
  Stream() { check_cuda(cudaStreamCreateWithFlags(&stream_, cudaStreamNonBlocking), "make a stream"); }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;
  ~Stream() { static_cast<void>(cudaStreamDestroy(stream_)); }

  void wait() const { check_cuda(cudaStreamSynchronize(stream_), "finish a frame's work"); }
  operator cudaStream_t() const { return stream_; }

 private:
  cudaStream_t stream_ = nullptr;
};

/// A mark in a stream: whether, and where it is timed when, the work before it was done.
class Event {
 public:
  enum class Kind : unsigned { plain = cudaEventDisableTiming, timed = cudaEventDefault };

  explicit Event(Kind kind = Kind::plain) {
    check_cuda(cudaEventCreateWithFlags(&event_, static_cast<unsigned>(kind)), "make an event");
  }
  Event(Event&& other) noexcept : event_(std::exchange(other.event_, nullptr)) {}
  Event& operator=(Event&&) = delete;
  ~Event() {
    if (event_ != nullptr) static_cast<void>(cudaEventDestroy(event_));
  }

  cudaEvent_t handle() const { return event_; }
  /// Returns at once where it was never recorded.
  void wait() const { check_cuda(cudaEventSynchronize(event_), "finish a frame's work"); }
  /// From an earlier mark to this one; both must be timed and have been passed.
  double ms_since(const Event& start) const {
    float ms = 0;
    check_cuda(cudaEventElapsedTime(&ms, start.event_, event_), "read an event");
    return ms;
  }

 private:
  cudaEvent_t event_ = nullptr;
};

}  // namespace facet
