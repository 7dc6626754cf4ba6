#pragma once

namespace facet {

enum class GradientOperator {
  sobel,    ///< 3x3 Sobel, scaled to metres per pixel
  central,  ///< plain central differences (figure 5's comparison)
};

struct GradientParams {
  GradientOperator op = GradientOperator::sobel;
};

}  // namespace facet
