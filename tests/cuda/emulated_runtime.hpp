#pragma once

#include <cstdint>
#include <cstring>
#include <cuda_runtime_api.h>
#include <functional>
#include <stdexcept>
#include <string>
#include <typeinfo>

#include "support/shuffled_grid.hpp"

namespace facet {

/// When the emulated device does what its streams hold.
enum class Eagerness {
  late,    ///< when the host waits for it, and no more of it than that: shows what nobody waited for
  random,  ///< now and then
  at_once,
};

/// How the emulated runtime behaves, and what it was asked for. It stands in for the library of CUDA: the
/// functions of it that the executor calls, for one thread, with memory of its own.
struct EmulatedRuntime {
  Eagerness eagerness = Eagerness::late;
  std::size_t memory_left = ~std::size_t{0};  ///< what cudaMalloc may still give [bytes]
  int living = 0;           ///< allocations, streams, events and graphs that were not given back
  int made = 0;             ///< the same, all that there ever were
  int waits = 0;            ///< of the host, where something was left to do
  int launches = 0;         ///< of kernels, those of graphs among them
  int single_launches = 0;  ///< of kernels, one by one
  int graphs = 0;           ///< that were launched
  bool takes_graphs = true;
  std::size_t uploaded = 0;  ///< bytes
  double now_ms = 0;         ///< goes on by 1 with every kernel that was done
};
EmulatedRuntime& emulated_runtime();

/// Whether an address is in memory of the device or in host memory that it may use.
bool device_may_use(const void* address);

/// Whether what looks like an address in the bytes of a kernel's argument is none of the host's alone: on a
/// device that would end the program. Numbers do not look like addresses of a process: as such, they would be
/// denormal, or of two, the second between 21760 and 32767.
template <class T>
bool holds_no_host_memory(const T& argument) {
  for (std::size_t at = 0; at + sizeof(std::uintptr_t) <= sizeof argument; at += sizeof(std::uintptr_t)) {
    std::uintptr_t word = 0;
    std::memcpy(&word, reinterpret_cast<const char*>(&argument) + at, sizeof word);
    const bool is_address = word >> 32 >= 0x5500 && word >> 32 <= 0x7fff;
    if (is_address && !device_may_use(reinterpret_cast<const void*>(word))) return false;
  }
  return true;
}

/// What stands at the address of a kernel: makes, of the arguments that it is called with, what it does.
struct EmulatedKernel {
  std::function<void()> (*bound)(dim3 blocks, dim3 threads, void** arguments);
};

/// In place of CudaKernels: threads in shuffled order.
class EmulatedKernels {
 public:
  template <class Op>
  static const void* for_each_pixel() {
    static constexpr EmulatedKernel kernel{[](dim3 blocks, dim3 threads, void** arguments) {
      return covering(blocks, threads, value<Size>(arguments[1]),
                      [op = value<Op>(arguments[0]), size = value<Size>(arguments[1])] {
                        grid().for_each_pixel(size, op);
                      });
    }};
    return &kernel;
  }
  template <class Op>
  static const void* add_up() {
    static constexpr EmulatedKernel kernel{[](dim3 blocks, dim3 threads, void** arguments) {
      return covering(blocks, threads, value<Size>(arguments[1]),
                      [op = value<Op>(arguments[0]), size = value<Size>(arguments[1]),
                       sum = value<unsigned long long*>(arguments[2])] {
                        *sum += static_cast<unsigned long long>(grid().sum_pixels(size, op));
                      });
    }};
    return &kernel;
  }
  static const void* publish_flag() {
    static constexpr EmulatedKernel kernel{[](dim3, dim3, void** arguments) -> std::function<void()> {
      return [flag = value<int*>(arguments[0]), host_slot = value<int*>(arguments[1])] {
        *host_slot = *flag;
        *flag = 0;
      };
    }};
    return &kernel;
  }

 private:
  template <class T>
  static T value(const void* argument) {
    if (!holds_no_host_memory(*static_cast<const T*>(argument)))
      throw std::logic_error(std::string("a kernel was given memory of the host: ") + typeid(T).name());
    return *static_cast<const T*>(argument);
  }
  static ShuffledGridExecutor& grid() {
    static ShuffledGridExecutor executor(3);
    return executor;
  }
  /// A launch must have a thread for every pixel.
  static std::function<void()> covering(dim3 blocks, dim3 threads, Size size, std::function<void()> work) {
    if (blocks.x * threads.x < static_cast<unsigned>(size.width) ||
        blocks.y * threads.y < static_cast<unsigned>(size.height))
      throw std::logic_error("a launch does not cover the image");
    return work;
  }
};

}  // namespace facet
