#pragma once

#include <cstdint>
#include <cstring>

namespace facet {

/// visit(x) for every non-zero byte of a row, from left to right; eight zeros at a time are passed over, so a
/// sparse row costs little. A byte is looked at just before its visit, which may clear it.
template <class Visit>
void for_each_set_in_row(const std::uint8_t* row, int width, const Visit& visit) {
  int x = 0;
  for (; x + 8 <= width; x += 8) {
    std::uint64_t word;
    std::memcpy(&word, row + x, sizeof word);
    if (word == 0) continue;
    for (int i = x; i < x + 8; ++i)
      if (row[i]) visit(i);
  }
  for (; x < width; ++x)
    if (row[x]) visit(x);
}

}  // namespace facet
