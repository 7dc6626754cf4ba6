#pragma once

#include <memory>

#include "method/registry.hpp"

namespace facet {

/// The edge-pair baseline (see edge_pairs/edge_pair_finder.hpp) on one frame at a time, without its past.
std::unique_ptr<Method> make_edge_pairs(const MethodSpec& spec, const MethodContext& context);

/// Edges and grasps, no regions.
std::optional<PredictedParts> yields_edge_pairs(const MethodSpec& spec);

}  // namespace facet
