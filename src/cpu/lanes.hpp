#pragma once

#include <cstring>

namespace facet {

/// Sixteen pixels side by side, for loops that the compiler does not vectorise well by itself: one register
/// with AVX-512, two with AVX2, four with SSE2. Comparisons give -1 where they hold. They are never passed
/// by value: how that is done depends on the instruction set.
using Floats = float __attribute__((vector_size(64)));
using Ints = int __attribute__((vector_size(64)));
inline constexpr int lanes = 16;

template <class Values, class T>
[[gnu::always_inline]] inline void load(const T* from, Values& values) {
  static_assert(sizeof values == lanes * sizeof(T));
  std::memcpy(&values, from, sizeof values);
}
template <class Values, class T>
[[gnu::always_inline]] inline void store(const Values& values, T* to) {
  static_assert(sizeof values == lanes * sizeof(T));
  std::memcpy(to, &values, sizeof values);
}

}  // namespace facet
