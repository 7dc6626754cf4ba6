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

/// How many of the ones and zeros between the ends are ones; eight at a time.
inline int count_ones(const std::uint8_t* begin, const std::uint8_t* end) {
  int count = 0;
  for (; end - begin >= 8; begin += 8) {
    std::uint64_t word;
    std::memcpy(&word, begin, sizeof word);
    if (word != 0) count += static_cast<int>(word * 0x0101010101010101u >> 56);
  }
  for (; begin != end; ++begin) count += *begin;
  return count;
}

}  // namespace facet
