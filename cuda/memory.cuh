#pragma once

#include <cstddef>
#include <utility>

#include "cuda/error.cuh"

namespace facet {

/// Bytes that a pair of functions of the CUDA runtime gives and takes back. Its memory is kept when less of
/// it is needed, so what has one size for every frame allocates once. Throws Error{not_measured} where there
/// is not enough.
template <class Allocator>
class CudaMemory {
 public:
  CudaMemory() = default;
  CudaMemory(CudaMemory&& other) noexcept { swap(other); }
  CudaMemory& operator=(CudaMemory&& other) noexcept {
    swap(other);
    return *this;
  }
  ~CudaMemory() { release(); }

  /// At least `bytes`; what was in it may be lost.
  void reserve(std::size_t bytes) {
    if (bytes <= capacity_) return;
    release();
    check_cuda(Allocator::allocate(&data_, bytes), Allocator::purpose);
    capacity_ = bytes;
  }
  template <class T>
  T* as() const {
    return static_cast<T*>(data_);
  }

 private:
  void swap(CudaMemory& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(capacity_, other.capacity_);
  }
  void release() noexcept {
    if (data_ != nullptr) static_cast<void>(Allocator::release(data_));
    data_ = nullptr;
    capacity_ = 0;
  }

  void* data_ = nullptr;
  std::size_t capacity_ = 0;
};

/// Memory of the device.
struct DeviceAllocator {
  static constexpr const char* purpose = "allocate device memory";
  static cudaError_t allocate(void** data, std::size_t bytes) { return cudaMalloc(data, bytes); }
  static cudaError_t release(void* data) { return cudaFree(data); }
};
/// Host memory that does not move, from which and to which copies run beside other work, and to which a
/// kernel may write.
struct PinnedAllocator {
  static constexpr const char* purpose = "allocate pinned host memory";
  static cudaError_t allocate(void** data, std::size_t bytes) {
    return cudaHostAlloc(data, bytes, cudaHostAllocPortable | cudaHostAllocMapped);
  }
  static cudaError_t release(void* data) { return cudaFreeHost(data); }
};
using DeviceMemory = CudaMemory<DeviceAllocator>;
using PinnedMemory = CudaMemory<PinnedAllocator>;

}  // namespace facet
