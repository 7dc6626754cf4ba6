#pragma once

#include <cstdint>

#include "score/frame_truth.hpp"
#include "surface/surface.hpp"

namespace facet {

/// Size of a largest set of pairs (a, b), every pixel in one pair at most, no pair farther apart than
/// `tolerance_px`: the nearest pixels are paired, then pairs are moved along augmenting paths (Kuhn 1955).
/// Pixels must lie in an image of that size, those of b listed once.
int match_one_to_one(const std::vector<ContourPoint>& a, const std::vector<ContourPoint>& b, Size size,
                     double tolerance_px);

/// Boundary pixels matched one to one, as in BSDS500 (Martin et al. 2004): precision matched / predicted,
/// recall matched / truth, F = 2 matched / (predicted + truth).
struct BoundaryCounts {
  int matched = 0, predicted = 0, truth = 0;
};

/// Edges whose boundary scores are given together.
enum class EdgeGroup { depth, crease };

/// Truth: the samples of all annotated edges of the group, rounded to pixels inside the image that are unique
/// for each kind.
/// Prediction: the edge pixels of the group in the region of interest, as they are (the format says one pixel
/// wide; what is wider costs precision).
BoundaryCounts score_boundary(const FrameTruth& frame, const Image<std::uint8_t>& codes, EdgeGroup group);

/// Pixels of the samples of all annotated edges of the group, unique for each kind.
std::vector<ContourPoint> boundary_truth(const FrameTruth& frame, EdgeGroup group);

}  // namespace facet
