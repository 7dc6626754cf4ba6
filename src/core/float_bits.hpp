#pragma once

#include <cstdint>
#include <cstring>

#include "core/host_device.hpp"

namespace facet {

/// The bits of a float. For floats that are not negative they are ordered as the floats.
FACET_HD inline std::uint32_t float_bits(float value) {
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

}  // namespace facet
