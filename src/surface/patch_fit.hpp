#pragma once

#include <array>

namespace facet {

/// What is known of a patch before it is measured, and how well it is measured.
struct PatchPrior {
  double reading_variance = 1;  ///< of q, of one independent reading, times the pixels that share a reading
  double slope = 1;             ///< deviation of dq/dx and dq/dy [1/m per px]
  double curvature = 1;         ///< deviation of the second derivatives of q [1/m per px^2]
};

/// Value of a patch at a pixel [1/m] and its slopes [1/m per px].
struct PatchPoint {
  double q = 0, qx = 0, qy = 0;
};

/// A quadric q(x, y) in inverse depth: the most likely one for the pixels of a region under the prior, which
/// makes small and noisy regions planes, and its uncertainty.
class PatchFit {
 public:
  PatchPoint at(double x_px, double y_px) const;
  /// Variances of the value [1/m^2] and of the two slopes together [1/m^2 per px^2].
  struct Variance {
    double value = 0, slope = 0;
  };
  Variance variance_at(double x_px, double y_px) const;
  /// Sum over the pixels of the squared distances of q from the patch [1/m^2].
  double squares() const { return squares_; }

 private:
  friend class PatchMoments;

  double x0_ = 0, y0_ = 0;           ///< centre of the region, in units
  std::array<double, 6> terms_{};    ///< of 1, x, y, x^2, xy, y^2 about the centre
  std::array<double, 21> factor_{};  ///< the normal equations' lower triangle, by rows, its diagonal inverted
  double reading_variance_ = 1;
  double squares_ = 0;
};

/// Sums from which a patch is fitted to the inverse depth of a region's pixels; those of two regions add up.
/// A plane in space is a plane in inverse depth; a quadric follows a curved surface to second order.
class PatchMoments {
 public:
  /// Pixels side by side in a row, the first one at (x, y) [px] relative to the principal point, with their q
  /// [1/m].
  template <class QAt>
  void add_run(double x_px, double y_px, int count, const QAt& q_at) {
    Row row = powers_of_run(px_unit * (x_px + 0.5 * (count - 1)), count);
    double x = px_unit * x_px;
    for (int k = 0; k < count; ++k, x += px_unit) {
      const double q = q_at(k), qx = q * x;
      row[5] += q, row[6] += qx, row[7] += qx * x;
      squares_ += q * q;
    }
    add_row(row, px_unit * y_px);
  }
  PatchMoments& operator+=(const PatchMoments& other);
  double count() const { return power(0, 0); }
  double mean_q() const { return product(0, 0) / count(); }
  /// The fit to at least one pixel.
  PatchFit fit(const PatchPrior& prior) const;

  /// Lengths in hundreds of pixels, so that all powers are of one order.
  static constexpr double px_unit = 0.01;

 private:
  /// Sums over pixels in a row: of 1, x, x^2, x^3, x^4, q, q x, q x^2.
  using Row = std::array<double, 8>;
  /// Those without q of a run about its middle `x`, by the sums of powers of consecutive numbers.
  static Row powers_of_run(double x, double count) {
    const double unit2 = px_unit * px_unit, n2 = count * count;
    const double spread2 = count * (n2 - 1) / 12 * unit2;        // of the squares about the middle
    const double spread4 = spread2 * (3 * n2 - 7) / 20 * unit2;  // of the fourth powers
    const double xx = x * x;
    return {count, count * x, count * xx + spread2, x * (count * xx + 3 * spread2),
            xx * (count * xx + 6 * spread2) + spread4};
  }
  void add_row(const Row& row, double y) {
    double of_y = 1;
    for (Row& sums : sums_) {
      for (std::size_t i = 0; i < row.size(); ++i) sums[i] += row[i] * of_y;
      of_y *= y;
    }
  }
  double power(std::size_t i, std::size_t j) const { return sums_[j][i]; }        ///< sum of x^i y^j
  double product(std::size_t i, std::size_t j) const { return sums_[j][5 + i]; }  ///< sum of q x^i y^j

  std::array<Row, 5> sums_{};  ///< [j]: times y^j
  double squares_ = 0;         ///< sum of q^2
};

inline PatchPoint PatchFit::at(double x_px, double y_px) const {
  const double x = PatchMoments::px_unit * x_px - x0_, y = PatchMoments::px_unit * y_px - y0_;
  const auto& [c, cx, cy, cxx, cxy, cyy] = terms_;
  return {c + x * (cx + cxx * x + cxy * y) + y * (cy + cyy * y),
          PatchMoments::px_unit * (cx + 2 * cxx * x + cxy * y),
          PatchMoments::px_unit * (cy + cxy * x + 2 * cyy * y)};
}

}  // namespace facet
