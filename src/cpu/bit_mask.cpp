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

/// Sixteen bytes of 0 or 1 as sixteen bits.
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
/// Sixteen bits as sixteen bytes of 0 or 1.
void to_bytes(std::uint64_t bits, std::uint8_t* bytes) {
  constexpr std::uint64_t places = 0x8040201008040201u;
#if defined(__SSE2__)
  const __m128i place = _mm_set1_epi64x(static_cast<std::int64_t>(places));
  __m128i spread = _mm_cvtsi32_si128(static_cast<int>(bits & 0xFFFF));
  spread = _mm_unpacklo_epi8(spread, spread);                            // each of the two bytes twice,
  spread = _mm_shuffle_epi32(_mm_unpacklo_epi16(spread, spread), 0x50);  // then eight times
  const __m128i is_set = _mm_cmpeq_epi8(_mm_and_si128(spread, place), place);
  _mm_storeu_si128(reinterpret_cast<__m128i*>(bytes), _mm_and_si128(is_set, _mm_set1_epi8(1)));
#else
  for (int half = 0; half < 2; ++half) {
    constexpr std::uint64_t ones = 0x0101010101010101u;
    const std::uint64_t spread = (bits >> 8 * half & 0xFF) * ones & places;
    const std::uint64_t word = (spread + 0x7F * ones) >> 7 & ones;
    std::memcpy(bytes + 8 * half, &word, sizeof word);
  }
#endif
}

FACET_CPU_CLONES void dilate_words(const std::uint64_t* row, std::ptrdiff_t pitch, std::ptrdiff_t count,
                                   std::uint64_t* out) {
  const std::uint64_t *above = row - pitch, *below = row + pitch;
#pragma GCC ivdep
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    const std::uint64_t left = above[k - 1] | row[k - 1] | below[k - 1];
    const std::uint64_t middle = above[k] | row[k] | below[k];
    const std::uint64_t right = above[k + 1] | row[k + 1] | below[k + 1];
    out[k] = middle | middle << 1 | left >> 63 | middle >> 1 | right << 63;
  }
}

template <class Combine>
void combine(BitMask& mask, const BitMask& other, int first, int behind, const Combine& combined) {
  std::uint64_t* to = mask.row(first) - 1;
  const std::uint64_t* from = other.row(first) - 1;
  const std::ptrdiff_t count = (behind - first) * mask.pitch();
  for (std::ptrdiff_t k = 0; k < count; ++k) to[k] = combined(to[k], from[k]);
}

void complement(BitMask& mask) {
  for (int y = 0; y < mask.size().height; ++y)
    for (int k = 0; k < mask.words(); ++k) mask.row(y)[k] = ~mask.row(y)[k];
  mask.clear_around(0, mask.size().height);
}

}  // namespace

void BitMask::resize(Size size) {
  size_ = size.empty() ? Size{} : size;
  pitch_ = (size_.width + 63) / 64 + 2;
  words_.assign(static_cast<std::size_t>(pitch_) * static_cast<std::size_t>(size_.height + 2), 0);
}

void BitMask::pack_row(int y, const std::uint8_t* bytes) {
  std::uint64_t* to = row(y);
  int x = 0;
  for (; x + 64 <= size_.width; x += 64)
    to[x / 64] = bits_of(bytes + x) | bits_of(bytes + x + 16) << 16 | bits_of(bytes + x + 32) << 32 |
                 bits_of(bytes + x + 48) << 48;
  for (; x < size_.width; ++x) to[x / 64] |= std::uint64_t{bytes[x]} << x % 64;
}

void BitMask::write_row(int y, std::uint8_t* bytes) const {
  const std::uint64_t* from = row(y);
  int x = 0;
  for (; x + 16 <= size_.width; x += 16) to_bytes(from[x / 64] >> x % 64, bytes + x);
  for (; x < size_.width; ++x) bytes[x] = from[x / 64] >> x % 64 & 1;
}

void BitMask::clear_around(int first, int behind) {
  for (int y = first; y < behind; ++y) {
    std::uint64_t* words_of_row = row(y);
    words_of_row[-1] = words_of_row[words()] = 0;
    if (words() > 0) words_of_row[words() - 1] &= last_word();
  }
}

void BitMask::swap(BitMask& other) noexcept {
  std::swap(size_, other.size_);
  std::swap(pitch_, other.pitch_);
  words_.swap(other.words_);
}

void dilate_square(int steps, BitMask& mask, BitMask& spare) {
  spare.resize(mask.size());
  const int height = mask.size().height;
  for (int i = 0; i < steps; ++i) {
    dilate_words(mask.row(0) - 1, mask.pitch(), height * mask.pitch(), spare.row(0) - 1);
    spare.clear_around(0, height);
    mask.swap(spare);
  }
}

void erode_square(int steps, BitMask& mask, BitMask& spare) {
  complement(mask);
  dilate_square(steps, mask, spare);
  complement(mask);
}

void subtract(BitMask& mask, const BitMask& other, int first, int behind) {
  combine(mask, other, first, behind, [](std::uint64_t a, std::uint64_t b) { return a & ~b; });
}
void subtract(BitMask& mask, const BitMask& other) {
  subtract(mask, other, 0, mask.size().height);
}
void intersect(BitMask& mask, const BitMask& other) {
  combine(mask, other, 0, mask.size().height, [](std::uint64_t a, std::uint64_t b) { return a & b; });
}
void unite(BitMask& mask, const BitMask& other) {
  combine(mask, other, 0, mask.size().height, [](std::uint64_t a, std::uint64_t b) { return a | b; });
}

}  // namespace facet
