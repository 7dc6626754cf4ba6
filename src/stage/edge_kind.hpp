#pragma once

namespace facet {

enum class Convexity {
  signed_test,  ///< (p2 - p1) . (n2 - n1) > 0 across the crease
  hessian,      ///< Table 1 with z as printed: sign of the dominant eigenvalue of the depth's Hessian
};

struct EdgeKindParams {
  Convexity convexity = Convexity::signed_test;
  float hessian_dead_band_per_m = 1.0f;  ///< hessian: curvature below this is undecided [1/m], 0..1000
};

}  // namespace facet
