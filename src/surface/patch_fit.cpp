#include "surface/patch_fit.hpp"

#include <Eigen/Dense>

#include "core/clones.hpp"

namespace facet {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr std::array<std::array<int, 2>, 6> exponents{{{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}}};

constexpr std::size_t at(int k) {
  return static_cast<std::size_t>(k);
}

/// Turns sums of x^i y^j, i + j < n, into those about (x0, y0), by Pascal's triangle.
template <std::size_t n>
void shift(std::array<std::array<double, n>, n>& sums, double x0, double y0) {
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t step = 1; step < n - k; ++step)
      for (std::size_t i = n - 1 - k; i >= step; --i) sums[i][k] -= x0 * sums[i - 1][k];
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t step = 1; step < n - k; ++step)
      for (std::size_t j = n - 1 - k; j >= step; --j) sums[k][j] -= y0 * sums[k][j - 1];
}

}  // namespace

PatchMoments& PatchMoments::operator+=(const PatchMoments& other) {
  for (std::size_t j = 0; j < sums_.size(); ++j)
    for (std::size_t i = 0; i < sums_[j].size(); ++i) sums_[j][i] += other.sums_[j][i];
  squares_ += other.squares_;
  return *this;
}

/// Maximum a posteriori: least squares about the centre, where the sums do not cancel, with the prior as
/// readings of zero slope and curvature.
PatchFit PatchMoments::fit(const PatchPrior& prior) const {
  PatchFit patch;
  patch.x0_ = power(1, 0) / count(), patch.y0_ = power(0, 1) / count();
  std::array<std::array<double, 5>, 5> powers;
  std::array<std::array<double, 3>, 3> products;
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = 0; i + j < 5; ++j) powers[i][j] = power(i, j);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; i + j < 3; ++j) products[i][j] = product(i, j);
  shift(powers, patch.x0_, patch.y0_);
  shift(products, patch.x0_, patch.y0_);
  Matrix6 normal;
  Vector6 right;
  for (int r = 0; r < 6; ++r) {
    const auto [ir, jr] = exponents[at(r)];
    for (int c = 0; c < 6; ++c) {
      const auto [ic, jc] = exponents[at(c)];
      normal(r, c) = powers[at(ir + ic)][at(jr + jc)];
    }
    right(r) = products[at(ir)][at(jr)] - mean_q() * normal(0, r);
  }
  const Matrix6 unbiased = normal;
  const double variance = prior.reading_variance;
  const double slope = prior.slope / px_unit, curvature = prior.curvature / (px_unit * px_unit);
  normal(1, 1) += variance / (slope * slope), normal(2, 2) += variance / (slope * slope);
  // A term of x^2 is half the second derivative, one of xy all of it.
  normal(3, 3) += 4 * variance / (curvature * curvature),
      normal(5, 5) += 4 * variance / (curvature * curvature);
  normal(4, 4) += variance / (curvature * curvature);
  const Eigen::LLT<Matrix6> factor(normal);
  const Vector6 terms = factor.solve(right);
  patch.squares_ = squares_ - count() * mean_q() * mean_q() + terms.dot(unbiased * terms - 2 * right);
  Eigen::Map<Vector6>(patch.terms_.data()) = terms;
  patch.terms_[0] += mean_q();
  patch.reading_variance_ = variance;
  double* stored = patch.factor_.data();
  for (int r = 0; r < 6; ++r) {
    for (int c = 0; c < r; ++c) *stored++ = factor.matrixLLT()(r, c);
    *stored++ = 1 / factor.matrixLLT()(r, r);
  }
  return patch;
}

FACET_CPU_CLONES PatchFit::Variance PatchFit::variance_at(double x_px, double y_px) const {
  constexpr double unit = PatchMoments::px_unit;
  const double x = unit * x_px - x0_, y = unit * y_px - y0_;
  // The covariance of the terms is the variance of a reading times the inverse of factor factor^T: solved
  // forward for the directions of the value and of the two slopes at once; a fourth column of zeros makes
  // full vectors.
  double v[6][4] = {{1, 0, 0},
                    {x, unit, 0},
                    {y, 0, unit},
                    {x * x, 2 * unit * x, 0},
                    {x * y, unit * y, unit * x},
                    {y * y, 0, 2 * unit * y}};
  double sum[4] = {};
  const double* factor = factor_.data();
  for (std::size_t r = 0; r < 6; ++r) {
    for (std::size_t c = 0; c < r; ++c, ++factor)
      for (std::size_t k = 0; k < 4; ++k) v[r][k] -= *factor * v[c][k];
    const double inverse = *factor++;
    for (std::size_t k = 0; k < 4; ++k) {
      v[r][k] *= inverse;
      sum[k] += v[r][k] * v[r][k];
    }
  }
  return {reading_variance_ * sum[0], reading_variance_ * (sum[1] + sum[2])};
}

}  // namespace facet
