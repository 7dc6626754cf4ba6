#pragma once

#include "core/host_device.hpp"

namespace facet {

/// The eight neighbours of a pixel, from the north clockwise. Rules written in bit operations alone decide
/// for one pixel, in bit 0 of an unsigned, or for as many pixels at once as a word has bits.
template <class Word>
struct Neighbours {
  Word p[8];
};

/// The neighbours of one pixel from its 8-neighbour code.
FACET_HD constexpr Neighbours<unsigned> neighbours_of(unsigned code) {
  return {{code & 1u, code >> 1 & 1u, code >> 2 & 1u, code >> 3 & 1u, code >> 4 & 1u, code >> 5 & 1u,
           code >> 6 & 1u, code >> 7 & 1u}};
}

/// Whether there is exactly one way round from clear to set, where diagonal neighbours count with the side
/// before them: the pixel touches one 8-connected piece, and one 4-connected piece of what is clear.
template <class Word>
FACET_HD constexpr Word one_crossing(const Word (&p)[8]) {
  const Word c0 = ~p[0] & (p[1] | p[2]), c1 = ~p[2] & (p[3] | p[4]);
  const Word c2 = ~p[4] & (p[5] | p[6]), c3 = ~p[6] & (p[7] | p[0]);
  return (c0 ^ c1 ^ c2 ^ c3) & ~((c0 & c1) | (c2 & c3));
}

}  // namespace facet
