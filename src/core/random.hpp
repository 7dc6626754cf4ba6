#pragma once

#include <cstdint>

#include "core/host_device.hpp"

namespace facet {

/// Counter-based random numbers: a value depends on (seed, stream, index) alone, so that it is the same on
/// every back end and in any order of evaluation. The mixing function is the finaliser of SplitMix64 (Steele
/// et al. 2014).
FACET_HD inline std::uint64_t mix_bits(std::uint64_t v) {
  v += 0x9E3779B97F4A7C15ull;
  v = (v ^ (v >> 30)) * 0xBF58476D1CE4E5B9ull;
  v = (v ^ (v >> 27)) * 0x94D049BB133111EBull;
  return v ^ (v >> 31);
}
FACET_HD inline std::uint64_t random_bits(std::uint64_t seed, std::uint64_t stream, std::uint64_t index) {
  return mix_bits(mix_bits(mix_bits(seed) ^ stream) ^ index);
}
/// Uniform in [0, 1).
FACET_HD inline float random_uniform(std::uint64_t seed, std::uint64_t stream, std::uint64_t index) {
  return static_cast<float>(random_bits(seed, stream, index) >> 40) * (1.0f / 16777216.0f);
}
/// Uniform integer in [0, n).
FACET_HD inline std::uint32_t random_below(std::uint32_t n, std::uint64_t seed, std::uint64_t stream,
                                           std::uint64_t index) {
  return static_cast<std::uint32_t>(((random_bits(seed, stream, index) >> 32) * n) >> 32);
}

}  // namespace facet
