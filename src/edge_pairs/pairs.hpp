#pragma once

#include <vector>

#include "edge_pairs/edge_features.hpp"
#include "prediction/prediction.hpp"

namespace facet {

/// Steps 6 and 7: pairs of edges that two fingers with friction can hold a surface by (planar force closure,
/// Nguyen 1988), each with the pose of the hand, best first; score = overlap [px] times the cosine of the
/// angle between the edges. The tests are made in the image: the edges face each other to within twice the
/// angle of friction, overlap by the width of a finger, the line that joins the contacts lies in both
/// friction cones, no depth edge crosses it, and in space the contacts are no farther apart than the jaw
/// opens. The hand approaches along the normal of the plane between the edges.
std::vector<FreeGrasp> find_pairs(const EdgePairParams& params, const EdgeScene& scene,
                                  const std::vector<EdgeFeature>& edges);

}  // namespace facet
