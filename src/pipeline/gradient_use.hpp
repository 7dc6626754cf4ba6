#pragma once

#include "pipeline/params.hpp"

namespace facet {

/// Whether any stage reads the depth gradient.
inline bool uses_gradient(const PipelineParams& p) {
  return p.dd.mode == DepthEdgeMode::canny || p.cd.mode != CreaseMode::normals ||
         p.edge_kind.convexity == Convexity::hessian;
}

}  // namespace facet
