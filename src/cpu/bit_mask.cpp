#include "cpu/bit_mask.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

#include "core/clones.hpp"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace facet {
namespace {

static_assert(std::endian::native == std::endian::little, "bytes and bits run the same way");

constexpr std::uint64_t ones = 0x0101010101010101u;

/// Sixteen bytes of 0 or 1 as sixteen bits; eight bits as eight bytes of 0 or 1.
std::uint64_t bits_of(const std::uint8_t* bytes) {
#if defined(__SSE2__)
  const __m128i ones_up = _mm_slli_epi16(_mm_loadu_si128(reinterpret_cast<const __m128i*>(bytes)), 7);
  return static_cast<unsigned>(_mm_movemask_epi8(ones_up));
#else
  std::uint64_t low, high;
  std::memcpy(&low, bytes, sizeof low);
  std::memcpy(&high, bytes + 8, sizeof high);
  return low * 0x0102040810204080u >> 56 | high * 0x0102040810204080u >> 56 << 8;
#endif
}
void to_bytes(std::uint64_t bits, std::uint8_t* bytes) {
  const std::uint64_t spread = (bits & 0xFF) * ones & 0x8040201008040201u;
  const std::uint64_t word = (spread + 0x7F * ones) >> 7 & ones;
  std::memcpy(bytes, &word, sizeof word);
}

FACET_CPU_CLONES void dilate_row(const std::uint64_t* above, const std::uint64_t* row,
                                 const std::uint64_t* below, int words, std::uint64_t* out) {
  for (int k = 0; k < words; ++k) {
    const std::uint64_t left = above[k - 1] | row[k - 1] | below[k - 1];
    const std::uint64_t middle = above[k] | row[k] | below[k];
    const std::uint64_t right = above[k + 1] | row[k + 1] | below[k + 1];
    out[k] = middle | middle << 1 | left >> 63 | middle >> 1 | right << 63;
  }
}

template <class Combine>
void combine(BitMask& mask, const BitMask& other, const Combine& combined) {
  for (int y = 0; y < mask.size().height; ++y)
    for (int k = 0; k < mask.words(); ++k) mask.row(y)[k] = combined(mask.row(y)[k], other.row(y)[k]);
}

void complement(BitMask& mask) {
  const int last = mask.words() - 1;
  for (int y = 0; y < mask.size().height; ++y) {
    std::uint64_t* row = mask.row(y);
    for (int k = 0; k <= last; ++k) row[k] = ~row[k];
    row[last] &= mask.last_word();
  }
}

}  // namespace

void BitMask::resize(Size size) {
  size_ = size.empty() ? Size{} : size;
  pitch_ = (size_.width + 63) / 64 + 2;
  words_.assign(static_cast<std::size_t>(pitch_) * static_cast<std::size_t>(size_.height + 2), 0);
}

void BitMask::assign(ImageView<const std::uint8_t> mask) {
  resize(mask.size());
  for (int y = 0; y < size_.height; ++y) pack(mask.row(y), row(y));
}

void BitMask::pack(const std::uint8_t* from, std::uint64_t* to) const {
  int x = 0;
  for (; x + 16 <= size_.width; x += 16) to[x / 64] |= bits_of(from + x) << x % 64;
  for (; x < size_.width; ++x) to[x / 64] |= std::uint64_t{from[x]} << x % 64;
}

void BitMask::write(ImageView<std::uint8_t> mask) const {
  for (int y = 0; y < size_.height; ++y) {
    const std::uint64_t* from = row(y);
    std::uint8_t* to = mask.row(y);
    int x = 0;
    for (; x + 8 <= size_.width; x += 8) to_bytes(from[x / 64] >> x % 64, to + x);
    for (; x < size_.width; ++x) to[x] = from[x / 64] >> x % 64 & 1;
  }
}

void BitMask::swap(BitMask& other) noexcept {
  std::swap(size_, other.size_);
  std::swap(pitch_, other.pitch_);
  words_.swap(other.words_);
}

void dilate_square(int steps, BitMask& mask, BitMask& spare) {
  spare.resize(mask.size());
  const int words = mask.words();
  for (int i = 0; i < steps; ++i) {
    for (int y = 0; y < mask.size().height; ++y) {
      dilate_row(mask.row(y - 1), mask.row(y), mask.row(y + 1), words, spare.row(y));
      spare.row(y)[words - 1] &= mask.last_word();
    }
    mask.swap(spare);
  }
}

void erode_square(int steps, BitMask& mask, BitMask& spare) {
  complement(mask);
  dilate_square(steps, mask, spare);
  complement(mask);
}

void subtract(BitMask& mask, const BitMask& other) {
  combine(mask, other, [](std::uint64_t a, std::uint64_t b) { return a & ~b; });
}
void intersect(BitMask& mask, const BitMask& other) {
  combine(mask, other, [](std::uint64_t a, std::uint64_t b) { return a & b; });
}
void unite(BitMask& mask, const BitMask& other) {
  combine(mask, other, [](std::uint64_t a, std::uint64_t b) { return a | b; });
}

}  // namespace facet
