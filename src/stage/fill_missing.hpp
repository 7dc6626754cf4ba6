#pragma once

namespace facet {

enum class FillPrefer {
  nearest,  ///< Algorithm 1: the neighbourhood mean nearest to a valid neighbour, from all sides
  far,      ///< the same, but a shadow is filled from its far side only: shadows belong to the background
};

struct FillParams {
  bool enabled = true;
  FillPrefer prefer = FillPrefer::far;
  int max_passes = 24;        ///< one pixel is filled per pass and side [passes], 0..512
  float rim_jump = 0.02f;     ///< relative depth jump across a hole that makes its near side a rim [m/m], 0..1
  int rim_search_px = 48;     ///< how far across a hole the other side is looked for [px], 1..256
};

}  // namespace facet
