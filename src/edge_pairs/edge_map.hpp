#pragma once

#include <cstdint>

#include "core/depth_noise.hpp"
#include "core/image.hpp"
#include "cpu/executor.hpp"
#include "edge_pairs/edge_pair_params.hpp"

namespace facet {

/// Least difference in depth that is a discontinuity, at that depth [m].
float least_jump_m(const EdgePairParams& params, const DepthNoise& noise, float depth_m);

/// Steps 1 to 3 of the edge-pair baseline: the depth image smoothed, and where depth or the direction of its
/// gradient changes at once. Keeps its memory between frames.
class EdgeMap {
 public:
  /// depth_m: 0 = missing.
  void compute(const EdgePairParams& params, const DepthNoise& noise, ImageView<const float> depth_m);

  ImageView<const float> depth_m() const { return depth_.view(); }                  ///< filled, 3x3 median
  ImageView<const std::uint8_t> depth_edges() const { return depth_edge_.view(); }  ///< on the nearer side
  ImageView<const std::uint8_t> edges() const { return edge_.view(); }              ///< all, one pixel wide

 private:
  void smooth(const EdgePairParams& params, const DepthNoise& noise, ImageView<const float> depth_m);
  void trace_creases(const EdgePairParams& params, const DepthNoise& noise);
  void unite(const EdgePairParams& params);

  CpuExecutor executor_;
  Image<float> depth_, raw_, proposal_, gx_, gy_, ux_, uy_, weight_, strength_;
  Image<std::uint8_t> depth_edge_, crease_edge_, edge_, direction_, ridge_, mask_a_, mask_b_;
};

}  // namespace facet
