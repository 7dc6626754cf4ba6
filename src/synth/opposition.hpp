#pragma once

#include <vector>

#include "synth/true_edges.hpp"

namespace facet {

/// Graspable edges of the face roughly oppose each other, or one that bends round it opposes itself: at some
/// pair of their points the directions into the face lie within the friction cones of a planar grasp with a
/// friction coefficient of 0.5 about the line that joins them (Nguyen, "Constructing force-closure grasps",
/// 1988).
bool has_opposing_edges(const std::vector<TrueEdge>& edges, std::uint16_t surface_id);

}  // namespace facet
