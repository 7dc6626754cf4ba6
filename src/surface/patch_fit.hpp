#pragma once

#include <array>

namespace facet {

/// Sums from which a plane, q = c + a x + b y, and a quadric, with terms in x^2, xy and y^2 more, are fitted
/// to the inverse depth of a region's pixels; those of two regions add up. A plane in space is a plane in
/// inverse depth; a quadric follows a curved surface to second order.
class PatchMoments {
 public:
  /// x, y [px] relative to the image centre, q [1/m].
  void add(double x_px, double y_px, double q);
  PatchMoments& operator+=(const PatchMoments& other);
  double count() const { return powers_[0][0]; }
  double mean_q() const { return products_[0][0] / powers_[0][0]; }
  /// Sums of squared residuals of the least-squares fits [1/m^2]; 0 where there are too few pixels.
  double plane_residual() const;
  double quadric_residual() const;

 private:
  template <int terms>
  double residual() const;

  std::array<std::array<double, 5>, 5> powers_{};    ///< [i][j]: sum of x^i y^j, i + j <= 4
  std::array<std::array<double, 3>, 3> products_{};  ///< [i][j]: sum of q x^i y^j, i + j <= 2
  double squares_ = 0;                               ///< sum of q^2
};

}  // namespace facet
