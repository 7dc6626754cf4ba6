#pragma once

#include <cuda_runtime_api.h>
#include <functional>

#include "support/shuffled_grid.hpp"

namespace facet {

/// When the emulated device does what its streams hold.
enum class Eagerness {
  late,    ///< when the host waits for it, and no more of it than that: shows what nobody waited for
  random,  ///< now and then
};

/// How the emulated runtime behaves, and what it was asked for. It stands in for the library of CUDA: the
/// functions of it that the executor calls, for one thread, with memory of its own.
struct EmulatedRuntime {
  Eagerness eagerness = Eagerness::late;
  std::size_t memory_left = ~std::size_t{0};  ///< what cudaMalloc may still give [bytes]
  int living = 0;                             ///< allocations, streams and events that were not given back
  int made = 0;                               ///< the same, all that there ever were
  int waits = 0;                              ///< of the host, where something was left to do
  int launches = 0;
  std::size_t uploaded = 0;  ///< bytes
};
EmulatedRuntime& emulated_runtime();

/// Puts work into a stream.
void enqueue(cudaStream_t stream, std::function<void()> work);

/// In place of CudaKernels: threads in shuffled order.
struct EmulatedKernels {
  template <class Op>
  static void for_each_pixel(const Op& op, Size size, cudaStream_t stream) {
    launch(stream, [=](ShuffledGridExecutor& grid) { grid.for_each_pixel(size, op); });
  }
  template <class Op>
  static void add_up(const Op& op, Size size, unsigned long long* sum, cudaStream_t stream) {
    launch(stream, [=](ShuffledGridExecutor& grid) {
      *sum += static_cast<unsigned long long>(grid.sum_pixels(size, op));
    });
  }
  static void publish_flag(int* flag, volatile int* host_slot, cudaStream_t stream) {
    launch(stream, [=](ShuffledGridExecutor&) {
      *host_slot = *flag;
      *flag = 0;
    });
  }

 private:
  template <class Work>
  static void launch(cudaStream_t stream, const Work& work) {
    ++emulated_runtime().launches;
    enqueue(stream, [work] {
      static ShuffledGridExecutor grid(3);
      work(grid);
    });
  }
};

}  // namespace facet
