#pragma once

#include <cstdint>
#include <limits>

#include "core/image_view.hpp"
#include "cuda/memory.cuh"
#include "cuda/work_queue.cuh"

namespace facet {

/// Owning image in device memory, row-major, rows padded to 128 bytes, with a copy in host memory once that
/// was asked for. Its memory is kept when it shrinks.
template <class T>
class DeviceImage {
 public:
  using value_type = T;

  /// Sets the size; the contents are zero afterwards unless the size was the same already. Waits for the
  /// device, which must have been given all work on this image: not so in the middle of a frame.
  void resize(Size size) {
    if (size == size_) return;
    size_ = size.empty() ? Size{} : size;
    stride_ = (size_.width + row_quantum - 1) / row_quantum * row_quantum;
    host_taken_at_ = never;
    if (size_.empty()) return;
    // The executors' streams and this do not wait for each other.
    check_cuda(cudaDeviceSynchronize(), "finish an image's work");
    memory_.reserve(bytes());
    check_cuda(cudaMemset(memory_.template as<T>(), 0, bytes()), "clear an image");
    check_cuda(cudaDeviceSynchronize(), "clear an image");
  }
  Size size() const { return size_; }
  ImageView<T> view() { return view_of(memory_.template as<T>()); }
  ImageView<const T> view() const { return view_of(memory_.template as<T>()); }

  /// Asks for a copy that is as old as work number `work` on the device, where work was done since the last
  /// one; whether it had to.
  bool ask_for_copy(std::uint64_t work, WorkQueue& queue) const {
    if (host_taken_at_ == work || size_.empty()) return false;
    host_.reserve(bytes());
    queue.copy(host_.template as<T>(), memory_.template as<T>(), bytes(), cudaMemcpyDeviceToHost);
    host_taken_at_ = work;
    return true;
  }
  /// Where the host finds that copy, once the queue has finished.
  ImageView<const T> host_view() const { return view_of(host_.template as<T>()); }

 private:
  static constexpr int row_quantum = 128 / static_cast<int>(sizeof(T));
  static constexpr std::uint64_t never = std::numeric_limits<std::uint64_t>::max();

  std::size_t bytes() const { return sizeof(T) * static_cast<std::size_t>(stride_) * size_.height; }
  ImageView<T> view_of(T* data) const { return {data, size_.width, size_.height, stride_}; }

  DeviceMemory memory_;
  Size size_;
  int stride_ = 0;
  mutable PinnedMemory host_;
  mutable std::uint64_t host_taken_at_ = never;
};

}  // namespace facet
