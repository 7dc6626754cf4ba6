#pragma once

#include <cstdint>

#include "core/launch.hpp"

namespace facet {

/// The one kernel of all stages: a thread per pixel. `op` stays where the launch has put it.
template <class Op>
__global__ void __launch_bounds__(Launch::block_width* Launch::block_height)
    pixel_kernel(const __grid_constant__ Op op, const Size size) {
  run_pixel_thread(op, size, static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x),
                   static_cast<int>(blockIdx.y * blockDim.y + threadIdx.y));
}

/// Adds the integers op(x, y) of all pixels to *sum: exact, so the order does not matter. Integers below zero
/// wrap round, which does not matter either.
template <class Op>
__global__ void __launch_bounds__(Launch::block_width* Launch::block_height)
    sum_kernel(const __grid_constant__ Op op, const Size size, unsigned long long* sum) {
  const int x = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
  const int y = static_cast<int>(blockIdx.y * blockDim.y + threadIdx.y);
  static_assert(Launch::block_width == 32, "a row of a block is a warp");
  auto value = static_cast<unsigned long long>(size.contains(x, y) ? static_cast<std::int64_t>(op(x, y))
                                                                   : std::int64_t{0});
  for (int step = 16; step > 0; step /= 2) value += __shfl_down_sync(0xFFFFFFFFu, value, step);
  if (threadIdx.x == 0 && value != 0) atomicAdd(sum, value);
}

/// Hands the flag of a pass to the host and lowers it for the next.
template <class Flag>
__global__ void publish_flag_kernel(Flag* flag, volatile Flag* host_slot) {
  *host_slot = *flag;
  *flag = 0;
}

/// Their addresses, by which the runtime launches them.
struct CudaKernels {
  /// op(x, y, access) for every pixel: called with op and the size.
  template <class Op>
  static const void* for_each_pixel() {
    return reinterpret_cast<const void*>(&pixel_kernel<Op>);
  }
  /// Adds the integers op(x, y) of all pixels to *sum: called with op, the size and `sum`.
  template <class Op>
  static const void* add_up() {
    return reinterpret_cast<const void*>(&sum_kernel<Op>);
  }
  /// *host_slot = *flag, *flag = 0: called with the two addresses, by one thread.
  static const void* publish_flag() { return reinterpret_cast<const void*>(&publish_flag_kernel<int>); }
};

}  // namespace facet
