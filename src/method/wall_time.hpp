#pragma once

#include <chrono>

namespace facet {

/// Milliseconds that a call takes.
template <class Function>
double milliseconds_of(const Function& function) {
  const auto start = std::chrono::steady_clock::now();
  function();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace facet
