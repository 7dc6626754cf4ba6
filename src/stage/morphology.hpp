#pragma once

namespace facet {

enum class MorphologyMode {
  region,  ///< bridge gaps, later drop regions that are too small
  paper,   ///< eqs 7-9: difference of two openings of the dilated contours
  none,
};

struct MorphologyParams {
  MorphologyMode mode = MorphologyMode::region;
  int bridge_px = 1;           ///< dilation that bridges gaps before thinning [px], 0..5
  int small_element_px = 3;    ///< paper: side of B2, odd [px], 3..31
  int large_element_px = 11;   ///< paper: side of B1, odd [px], 3..63
};

}  // namespace facet
