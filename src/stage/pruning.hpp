#pragma once

namespace facet {

enum class PruningMode {
  stability,  ///< remove every open branch: what is left bounds a region
  gonzalez,   ///< eq. 10: n thinnings by end points, then n conditional dilations from the new ends
  none,
};

struct PruningParams {
  PruningMode mode = PruningMode::stability;
  int iterations = 10;  ///< gonzalez: n, the longest spur that vanishes [px], 0..100
};

}  // namespace facet
