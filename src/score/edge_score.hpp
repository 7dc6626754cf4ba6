#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "score/frame_truth.hpp"
#include "score/outcomes.hpp"
#include "score/tally.hpp"

namespace facet {

/// Truth edges that count, by class; hit = detected.
struct EdgeRecall {
  Tally graspable, all, depth, convex, concave;
};

/// Predicted edge pixels in the region of interest, by their kind; hit = near a truth line of that kind.
struct EdgePrecision {
  Tally all, depth, convex, concave;
};

/// Scores of edges at the tolerance named 6px (0.0075 of the diagonal), at 3 px, and at 1 ... 10 px.
struct EdgeScore {
  EdgeRecall recall_6px, recall_3px;
  EdgeRecall recall_kind_ignored_6px, recall_kind_ignored_3px;
  EdgePrecision precision_6px, precision_3px;
  Tally precision_kind_ignored_6px, precision_kind_ignored_3px;
  std::array<EdgeRecall, edge_curve_px> recall_curve{};
  std::array<Tally, edge_curve_px> precision_curve{};
  std::vector<EdgeOutcome> outcomes{};  ///< of the edges that count
};

/// `codes` is the edge image of a prediction, of the size of the truth. Throws Error{data} for an unknown
/// code. A sample is hit if a predicted pixel of the same kind lies within the tolerance of its real
/// position; an edge is detected if at least 70 % of its samples are hit and, at 70 % of those, the nearest
/// pixel of the same kind (or one as near) is labelled rightly. `kind_ignored`: any predicted pixel hits, and
/// labels do not matter.
EdgeScore score_edges(const FrameTruth& frame, const Image<std::uint8_t>& codes);

/// Whether a predicted edge pixel counts for precision: within region_of_interest_px of an object mask or
/// surface polygon, and not void unless a truth edge of whatever kind is within the tolerance.
bool is_of_interest(const FrameTruth& frame, int x, int y, double tolerance_px);

}  // namespace facet
