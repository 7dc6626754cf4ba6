#pragma once

#include <array>

#include "cpu/executor.hpp"

namespace facet {

/// Makes `bits` of rows of zeros and ones, which mark_row(y, bytes) writes.
template <class MarkRow>
void pack_rows(CpuExecutor& executor, Size size, BitMask& bits, const MarkRow& mark_row) {
  constexpr int most = 32768;  // images are smaller
  bits.resize(size);
  executor.for_each_band(bits.size().height, [&](int begin, int end) {
    std::array<std::uint8_t, most> bytes;
    for (int y = begin; y < end; ++y) {
      mark_row(y, bytes.data());
      bits.pack_row(y, bytes.data());
    }
  });
}

/// A mask of zeros and ones with a byte for each pixel, as bits, and back.
inline void pack(CpuExecutor& executor, ImageView<const std::uint8_t> mask, BitMask& bits) {
  bits.resize(mask.size());
  executor.for_each_row(bits.size().height, [&](int y) { bits.pack_row(y, mask.row(y)); });
}
inline void unpack(CpuExecutor& executor, const BitMask& bits, ImageView<std::uint8_t> mask) {
  executor.for_each_row(bits.size().height, [&](int y) { bits.write_row(y, mask.row(y)); });
}

}  // namespace facet
