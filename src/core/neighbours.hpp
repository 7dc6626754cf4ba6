#pragma once

#include "core/host_device.hpp"

namespace facet {

struct Offset {
  int dx, dy;
};

/// The eight neighbours, clockwise from the north: bit i of an 8-neighbour code stands for neighbour i.
FACET_HD constexpr Offset neighbour8(int i) {
  constexpr Offset offsets[8]{{0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}};
  return offsets[i];
}

/// The four directions across a pixel: 0 = x, 1 = falling diagonal, 2 = y, 3 = rising diagonal.
FACET_HD constexpr Offset direction4(int i) {
  constexpr Offset offsets[4]{{1, 0}, {1, 1}, {0, 1}, {-1, 1}};
  return offsets[i];
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
