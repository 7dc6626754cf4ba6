#pragma once

#include <cstdint>

#include "core/atomic.hpp"
#include "core/image_view.hpp"
#include "core/neighbours.hpp"

namespace facet {

enum class FillPrefer {
  nearest,  ///< Algorithm 1: the neighbourhood mean nearest to a valid neighbour, from all sides
  far,      ///< the same, but a shadow is filled from its far side only: shadows belong to the background
};

struct FillParams {
  bool enabled = true;
  FillPrefer prefer = FillPrefer::far;
  int max_passes = 24;     ///< one pixel is filled per pass and side [passes], 0..512
  int max_hole_px = 40;    ///< widest hole, along its row or column, that is filled; 0 = any [px], 0..4096
  float rim_jump = 0.02f;  ///< relative depth jump across a hole that makes its near side a rim [m/m], 0..1
  int rim_search_px = 48;  ///< how far across a hole the other side is looked for [px], 1..256
};

/// Marks the missing pixels that belong to a hole narrow enough, along its row or its column, to be filled.
struct FillableOp {
  static constexpr int radius = 0;
  ImageView<const float> depth_m;
  int max_hole_px;
  ImageView<std::uint8_t> open;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    const bool missing = !(depth_m(x, y) > 0);
    open(x, y) = missing && (max_hole_px == 0 || narrow(x, y, 1, 0) || narrow(x, y, 0, 1));
  }

 private:
  /// Missing run through (x, y) along (dx, dy): both ends measured, no longer than max_hole_px.
  FACET_HD bool narrow(int x, int y, int dx, int dy) const {
    int length = 1;
    for (int side = -1; side <= 1; side += 2) {
      int px = x + side * dx, py = y + side * dy;
      while (length <= max_hole_px && depth_m.size().contains(px, py) && !(depth_m(px, py) > 0))
        px += side * dx, py += side * dy, ++length;
      if (length > max_hole_px || !depth_m.size().contains(px, py)) return false;
    }
    return true;
  }
};

/// Marks the near rim of holes: measured pixels beside a hole on whose other side the depth is larger by more
/// than the jump (the search of PCL's organized edge detection). A shadow is not filled from there.
struct FillRimOp {
  static constexpr int radius = 1;
  ImageView<const float> depth_m;
  float jump;
  int search_px;
  ImageView<std::uint8_t> rim;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access access) const {
    const float z = depth_m(x, y);
    bool is_rim = false;
    if (z > 0)
      for (int i = 0; i < 8; ++i) {
        const Offset d = neighbour8(i);
        if (!(access.clamped(depth_m, x + d.dx, y + d.dy) > 0))
          is_rim |= opposite_depth(x, y, d) > z * (1 + jump);
      }
    rim(x, y) = is_rim;
  }

 private:
  FACET_HD float opposite_depth(int x, int y, Offset d) const {
    for (int step = 1; step <= search_px; ++step) {
      const int px = x + step * d.dx, py = y + step * d.dy;
      if (!depth_m.size().contains(px, py)) return 0;
      if (depth_m(px, py) > 0) return depth_m(px, py);
    }
    return 0;
  }
};

/// A window mean offered as filling, and how far it is from the neighbour that offers it. Nearer is better,
/// of equally near ones the farther depth.
struct FillOffer {
  float mean_m = 0, distance_m = 1e30f;

  FACET_HD void take_better(const FillOffer& other) {
    const bool better =
        (other.distance_m < distance_m) | ((other.distance_m == distance_m) & (other.mean_m > mean_m));
    mean_m = better ? other.mean_m : mean_m;
    distance_m = better ? other.distance_m : distance_m;
  }
};

/// What fills one pixel of a hole: among all measured neighbours b that are no rim and all nine 3x3 windows
/// that contain b, the window mean nearest to b. 0 = no such neighbour yet.
struct FillCandidate {
  ImageView<const float> depth_m;
  ImageView<const std::uint8_t> rim;

  FACET_HD float source(int x, int y) const {
    return depth_m.size().contains(x, y) && !rim(x, y) ? depth_m(x, y) : 0.0f;
  }
  /// Column by column, so that the columns can be summed side by side.
  FACET_HD float window_mean(int x, int y) const {
    float sum = 0, n = 0;
    for (int dx = -1; dx <= 1; ++dx) {
      float column = 0;
      for (int dy = -1; dy <= 1; ++dy) {
        const float z = source(x + dx, y + dy);
        column += z;
        n += z > 0 ? 1.0f : 0.0f;
      }
      sum += column;
    }
    return sum / n;
  }
  /// The best window of the source (x, y), whose depth is b_m.
  FACET_HD FillOffer offer(int x, int y, float b_m) const {
    FillOffer best;
    for (int wy = y - 1; wy <= y + 1; ++wy)
      for (int wx = x - 1; wx <= x + 1; ++wx) {
        const float mean = window_mean(wx, wy);
        best.take_better({mean, mean > b_m ? mean - b_m : b_m - mean});
      }
    return best;
  }
  FACET_HD float operator()(int x, int y) const {
    FillOffer best;
    for (int i = 0; i < 8; ++i) {
      const int bx = x + neighbour8(i).dx, by = y + neighbour8(i).dy;
      const float b = source(bx, by);
      if (b > 0) best.take_better(offer(bx, by, b));
    }
    return best.mean_m;
  }
};

/// First half of a pass: candidates from the state before the pass, so that the order of pixels does not
/// matter.
struct FillProposeOp {
  static constexpr int radius = 0;
  FillCandidate candidate;
  ImageView<float> proposal_m;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    proposal_m(x, y) = candidate(x, y);
  }
};

/// Second half of a pass: takes the candidates over and closes their pixels.
struct FillAcceptOp {
  static constexpr int radius = 0;
  ImageView<const float> proposal_m;
  ImageView<float> depth_m;
  ImageView<std::uint8_t> open;
  ImageView<std::uint8_t> filled;
  int* changed;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    const float z = proposal_m(x, y);
    if (!(z > 0)) return;
    depth_m(x, y) = z;
    open(x, y) = 0;
    filled(x, y) = 1;
    raise_flag(changed);
  }
};

/// Scratch images of fill_missing, all of the frame's size.
struct FillScratch {
  ImageView<std::uint8_t> open, rim;
  ImageView<float> proposal_m;
};

/// Marks what may be filled (scratch.open) and from where it must not be (scratch.rim).
template <class Executor>
void mark_holes(Executor& executor, const FillParams& params, ImageView<const float> depth_m,
                const FillScratch& scratch) {
  executor.for_each_pixel(depth_m.size(), FillableOp{depth_m, params.max_hole_px, scratch.open});
  if (params.prefer == FillPrefer::far)
    executor.for_each_pixel(depth_m.size(),
                            FillRimOp{depth_m, params.rim_jump, params.rim_search_px, scratch.rim});
  else
    executor.fill(scratch.rim, std::uint8_t{0});
}

/// Fills missing depth in place from the borders of each hole inwards, one pixel per pass (paper Algorithm 1
/// in its gather form: mean over valid pixels only, independent of the order of pixels). `filled` is set to 1
/// where a value was made up, 0 elsewhere.
template <class Executor>
void fill_missing(Executor& executor, const FillParams& params, ImageView<float> depth_m,
                  ImageView<std::uint8_t> filled, const FillScratch& scratch) {
  mark_holes(executor, params, depth_m, scratch);
  executor.fill(filled, std::uint8_t{0});
  executor.take_changed();
  for (int pass = 0; pass < params.max_passes; ++pass) {
    executor.for_each_set(scratch.open, FillProposeOp{{depth_m, scratch.rim}, scratch.proposal_m});
    executor.for_each_set(scratch.open, FillAcceptOp{scratch.proposal_m, depth_m, scratch.open, filled,
                                                     executor.changed_flag()});
    if (!executor.take_changed()) break;
  }
}

}  // namespace facet
