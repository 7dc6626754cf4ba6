#pragma once

#include <array>

namespace facet {

/// Sums from which a plane, q = c + a x + b y, and a quadric, with terms in x^2, xy and y^2 more, are fitted
/// to the inverse depth of a region's pixels; those of two regions add up. A plane in space is a plane in
/// inverse depth; a quadric follows a curved surface to second order.
class PatchMoments {
 public:
  /// Pixels side by side in a row, the first one at (x, y) [px] relative to the image centre, with their q
  /// [1/m].
  template <class QAt>
  void add_run(double x_px, double y_px, int count, const QAt& q_at) {
    double powers[5] = {}, products[3] = {};
    for (int k = 0; k < count; ++k) {
      const double x = px_unit * (x_px + k), q = q_at(k), xx = x * x;
      powers[0] += 1, powers[1] += x, powers[2] += xx, powers[3] += xx * x, powers[4] += xx * xx;
      products[0] += q, products[1] += q * x, products[2] += q * xx;
      squares_ += q * q;
    }
    add_row(powers, products, px_unit * y_px);
  }
  PatchMoments& operator+=(const PatchMoments& other);
  double count() const { return powers_[0][0]; }
  double mean_q() const { return products_[0][0] / powers_[0][0]; }
  /// Sums of squared residuals of the least-squares fits [1/m^2]; 0 where there are too few pixels.
  double plane_residual() const;
  double quadric_residual() const;

 private:
  /// Lengths in hundreds of pixels, so that all powers are of one order.
  static constexpr double px_unit = 0.01;

  /// Sums of x^i and of q x^i over a row at y.
  void add_row(const double (&powers)[5], const double (&products)[3], double y);
  template <int terms>
  double residual() const;

  std::array<std::array<double, 5>, 5> powers_{};    ///< [i][j]: sum of x^i y^j, i + j <= 4
  std::array<std::array<double, 3>, 3> products_{};  ///< [i][j]: sum of q x^i y^j, i + j <= 2
  double squares_ = 0;                               ///< sum of q^2
};

}  // namespace facet
