#pragma once

#include "core/host_device.hpp"

namespace facet {

struct Offset {
  int dx, dy;
};

/// The eight neighbours, clockwise from the north: bit i of an 8-neighbour code stands for neighbour i.
/// (Offsets plus one, two bits each, in a number: a table would not be inlined into the loops.)
FACET_HD constexpr Offset neighbour8(int i) {
  constexpr unsigned dx_plus_one = 0x01A9, dy_plus_one = 0x1A90;
  return {static_cast<int>(dx_plus_one >> (2 * i) & 3u) - 1,
          static_cast<int>(dy_plus_one >> (2 * i) & 3u) - 1};
}
static_assert(neighbour8(0).dx == 0 && neighbour8(0).dy == -1 && neighbour8(2).dx == 1 &&
              neighbour8(2).dy == 0);
static_assert(neighbour8(5).dx == -1 && neighbour8(5).dy == 1 && neighbour8(7).dx == -1 &&
              neighbour8(7).dy == -1);

/// The four directions across a pixel: 0 = x, 1 = falling diagonal, 2 = y, 3 = rising diagonal.
FACET_HD constexpr Offset direction4(int i) {
  return neighbour8(i + 2);
}

/// Direction4 nearest to the vector (x, y): sectors of 45 degrees, told apart without an angle.
FACET_HD inline int direction4_of(float x, float y) {
  constexpr float tan_22_5 = 0.41421356f;
  const float ax = x < 0 ? -x : x;
  const float ay = y < 0 ? -y : y;
  const int diagonal = (x < 0) == (y < 0) ? 1 : 3;
  return ay <= tan_22_5 * ax ? 0 : (ax <= tan_22_5 * ay ? 2 : diagonal);
}

}  // namespace facet
