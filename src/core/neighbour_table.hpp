#pragma once

#include <cstdint>

#include "core/image_view.hpp"
#include "core/neighbours.hpp"

namespace facet {

/// A yes/no for each of the 256 states of a pixel's eight neighbours, as bits: small enough to travel with an
/// operation to the device.
struct NeighbourTable {
  std::uint32_t bits[8] = {};
  FACET_HD constexpr bool operator[](unsigned code) const { return bits[code >> 5] >> (code & 31u) & 1u; }
};

template <class Rule>
constexpr NeighbourTable make_neighbour_table(Rule rule) {
  NeighbourTable table;
  for (unsigned code = 0; code < 256; ++code)
    if (rule(code)) table.bits[code >> 5] |= 1u << (code & 31u);
  return table;
}

/// State of the eight neighbours of (x, y): bit i = neighbour8(i) is set; outside the image nothing is set.
FACET_HD inline unsigned neighbour_code(const ImageView<const std::uint8_t>& mask, int x, int y) {
  unsigned code = 0;
  const bool inside = x > 0 && y > 0 && x < mask.width - 1 && y < mask.height - 1;
  for (int i = 0; i < 8; ++i) {
    const int nx = x + neighbour8(i).dx, ny = y + neighbour8(i).dy;
    if ((inside || mask.size().contains(nx, ny)) && mask(nx, ny)) code |= 1u << i;
  }
  return code;
}

}  // namespace facet
