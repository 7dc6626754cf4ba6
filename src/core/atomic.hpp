#pragma once

#if !defined(__CUDA_ARCH__)
#include <atomic>
#endif
#include <cstdint>

#include "core/host_device.hpp"

namespace facet {

/// Lowers *target to `value` if that is smaller and returns what stood there before; safe from many threads.
FACET_HD inline int fetch_min(int* target, int value) {
#if defined(__CUDA_ARCH__)
  return atomicMin(target, value);
#else
  std::atomic_ref<int> cell(*target);
  int seen = cell.load(std::memory_order_relaxed);
  while (value < seen && !cell.compare_exchange_weak(seen, value, std::memory_order_relaxed)) {
  }
  return seen;
#endif
}

/// Adds to *target and returns what stood there before; safe from many threads. Wraps round.
FACET_HD inline std::int32_t fetch_add(std::int32_t* target, std::int32_t value) {
#if defined(__CUDA_ARCH__)
  return atomicAdd(target, value);
#else
  return std::atomic_ref<std::int32_t>(*target).fetch_add(value, std::memory_order_relaxed);
#endif
}
FACET_HD inline std::int64_t fetch_add(std::int64_t* target, std::int64_t value) {
#if defined(__CUDA_ARCH__)
  return static_cast<std::int64_t>(
      atomicAdd(reinterpret_cast<unsigned long long*>(target), static_cast<unsigned long long>(value)));
#else
  return std::atomic_ref<std::int64_t>(*target).fetch_add(value, std::memory_order_relaxed);
#endif
}

/// Raises a flag that several threads may raise at once.
FACET_HD inline void raise_flag(int* flag) {
#if defined(__CUDA_ARCH__)
  *flag = 1;
#else
  std::atomic_ref<int>(*flag).store(1, std::memory_order_relaxed);
#endif
}

}  // namespace facet
