#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

namespace facet {

/// First x >= from at which the row has another value, or its end. Looks at eight bytes at a time.
template <class T>
int end_of_run(const T* row, int from, int width, T value) {
  static_assert(sizeof(T) <= 4 && std::endian::native == std::endian::little);
  constexpr int step = 8 / static_cast<int>(sizeof(T));
  T pattern[step];
  for (T& p : pattern) p = value;
  std::uint64_t equal, word;
  std::memcpy(&equal, pattern, sizeof equal);
  int x = from;
  for (; x + step <= width; x += step) {
    std::memcpy(&word, row + x, sizeof word);
    if (word != equal) return x + std::countr_zero(word ^ equal) / static_cast<int>(8 * sizeof(T));
  }
  while (x < width && row[x] == value) ++x;
  return x;
}

}  // namespace facet
