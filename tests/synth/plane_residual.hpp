#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/image.hpp"

namespace facet {

/// How readings scatter about a plane, in one square patch.
struct PatchResidual {
  double depth_m = 0, sigma_m = 0;
  double lag1_x = 0, lag1_y = 0;  ///< correlation of neighbours in a row and in a column
};

/// Least-squares plane (inverse depth is linear in the image) through a patch; sigma < 0 where a reading is
/// missing.
inline PatchResidual patch_residual(const Image<float>& depth, int x0, int y0, int side) {
  PatchResidual out{.sigma_m = -1};
  const double c = 0.5 * (side - 1), spread = side * side * (side * side - 1.0) / 12;
  double mean = 0, slope_x = 0, slope_y = 0;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const double z = depth(x0 + x, y0 + y);
      if (z <= 0) return out;
      mean += 1 / z / (side * side);
      slope_x += (x - c) / z / spread;
      slope_y += (y - c) / z / spread;
      out.depth_m += z / (side * side);
    }
  }
  std::vector<double> r(static_cast<std::size_t>(side * side));
  double squares = 0, row = 0, column = 0;
  for (int k = 0; k < side * side; ++k) {
    const int x = k % side, y = k / side;
    const double z = depth(x0 + x, y0 + y);
    r[static_cast<std::size_t>(k)] = z - 1 / (mean + slope_x * (x - c) + slope_y * (y - c));
    squares += r[static_cast<std::size_t>(k)] * r[static_cast<std::size_t>(k)];
    if (x > 0) row += r[static_cast<std::size_t>(k)] * r[static_cast<std::size_t>(k - 1)];
    if (y > 0) column += r[static_cast<std::size_t>(k)] * r[static_cast<std::size_t>(k - side)];
  }
  const double variance = squares / (side * side), pairs = side * (side - 1.0);
  out.sigma_m = std::sqrt(variance);
  out.lag1_x = row / pairs / variance;
  out.lag1_y = column / pairs / variance;
  return out;
}

/// Medians over all patches of 31 px without a gap, flat (sigma under 0.6 % of the depth), nearest_m to
/// farthest_m.
inline PatchResidual median_residual(const Image<float>& depth, double nearest_m, double farthest_m) {
  constexpr int side = 31;
  std::vector<double> z, sigma, x1, y1;
  for (int y = 0; y + side <= depth.height(); y += side) {
    for (int x = 0; x + side <= depth.width(); x += side) {
      const PatchResidual p = patch_residual(depth, x, y, side);
      if (p.sigma_m < 0 || p.sigma_m > 0.006 * p.depth_m || p.depth_m < nearest_m || p.depth_m > farthest_m)
        continue;
      z.push_back(p.depth_m), sigma.push_back(p.sigma_m), x1.push_back(p.lag1_x), y1.push_back(p.lag1_y);
    }
  }
  const auto median = [](std::vector<double> v) {
    if (v.empty()) return 0.0;
    std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
    return v[v.size() / 2];
  };
  return {median(z), median(sigma), median(x1), median(y1)};
}

inline double missing_share(const Image<float>& depth) {
  double missing = 0;
  for (int y = 0; y < depth.height(); ++y) {
    for (int x = 0; x < depth.width(); ++x) missing += depth(x, y) <= 0;
  }
  return missing / static_cast<double>(depth.size().area());
}

}  // namespace facet
