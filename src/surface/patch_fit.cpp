#include "surface/patch_fit.hpp"

#include <cmath>

#include "core/clones.hpp"
#include "core/host_device.hpp"

namespace facet {
namespace {

constexpr std::size_t terms = 6;
constexpr std::array<std::array<std::size_t, 2>, terms> exponents{
    {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}}};

/// Place of row r, column c <= r in a lower triangle by rows.
constexpr std::size_t at(std::size_t r, std::size_t c) {
  return r * (r + 1) / 2 + c;
}

/// Cholesky factor of a symmetric matrix in place, its diagonal inverted. As loops of known length it takes
/// half the time of a general one, and fits are thousands a frame.
inline void factorise(std::array<double, 21>& m) {
  FACET_UNROLL for (std::size_t c = 0; c < terms; ++c) {
    for (std::size_t k = 0; k < c; ++k)
      for (std::size_t r = c; r < terms; ++r) m[at(r, c)] -= m[at(r, k)] * m[at(c, k)];
    m[at(c, c)] = 1 / std::sqrt(m[at(c, c)]);
    for (std::size_t r = c + 1; r < terms; ++r) m[at(r, c)] *= m[at(c, c)];
  }
}

/// Solves for the right side, in place.
inline void solve(const std::array<double, 21>& factor, std::array<double, terms>& right) {
  for (std::size_t r = 0; r < terms; ++r) {
    for (std::size_t c = 0; c < r; ++c) right[r] -= factor[at(r, c)] * right[c];
    right[r] *= factor[at(r, r)];
  }
  for (std::size_t r = terms; r-- > 0;) {
    right[r] *= factor[at(r, r)];
    for (std::size_t c = 0; c < r; ++c) right[c] -= factor[at(r, c)] * right[r];
  }
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

  const double variance = prior.reading_variance;
  const double slope = prior.slope / px_unit, curvature = prior.curvature / (px_unit * px_unit);
  const double of_slope = variance / (slope * slope), of_curvature = variance / (curvature * curvature);
  // A term of x^2 is half the second derivative, one of xy all of it.
  const std::array<double, terms> weight{
      0, of_slope, of_slope, 4 * of_curvature, of_curvature, 4 * of_curvature};
  std::array<double, terms> right;
  for (std::size_t r = 0; r < terms; ++r) {
    const auto [ir, jr] = exponents[r];
    for (std::size_t c = 0; c <= r; ++c)
      patch.factor_[at(r, c)] = powers[ir + exponents[c][0]][jr + exponents[c][1]];
    right[r] = products[ir][jr] - mean_q() * patch.factor_[at(r, 0)];
    patch.factor_[at(r, r)] += weight[r];
  }
  factorise(patch.factor_);
  patch.terms_ = right;
  solve(patch.factor_, patch.terms_);
  // The normal equations say what the terms explain of the squares.
  patch.squares_ = squares_ - count() * mean_q() * mean_q();
  for (std::size_t r = 0; r < terms; ++r)
    patch.squares_ -= patch.terms_[r] * (right[r] + weight[r] * patch.terms_[r]);
  patch.terms_[0] += mean_q();
  patch.reading_variance_ = variance;
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
