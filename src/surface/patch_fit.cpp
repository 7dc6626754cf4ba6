#include "surface/patch_fit.hpp"

#include <Eigen/Dense>

namespace facet {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr std::array<std::array<int, 2>, 6> exponents{{{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}}};
constexpr std::array<std::array<double, 5>, 5> binomials{
    {{1, 0, 0, 0, 0}, {1, 1, 0, 0, 0}, {1, 2, 1, 0, 0}, {1, 3, 3, 1, 0}, {1, 4, 6, 4, 1}}};

/// Powers 0 to 4 of a number.
std::array<double, 5> powers_of(double v) {
  return {1, v, v * v, v * v * v, v * v * v * v};
}

constexpr std::size_t at(int k) {
  return static_cast<std::size_t>(k);
}

/// Sum about another origin of x^i y^j, given the sums about the old one; px, py: powers of minus the way
/// there.
template <std::size_t n>
double shifted(const std::array<std::array<double, n>, n>& sums, int i, int j,
               const std::array<double, 5>& px, const std::array<double, 5>& py) {
  double total = 0;
  for (int a = 0; a <= i; ++a)
    for (int b = 0; b <= j; ++b)
      total += binomials[at(i)][at(a)] * binomials[at(j)][at(b)] * px[at(i - a)] * py[at(j - b)] *
               sums[at(a)][at(b)];
  return total;
}

}  // namespace

void PatchMoments::add_row(const double (&powers)[5], const double (&products)[3], double y) {
  double of_y = 1;
  for (std::size_t j = 0; j < 5; ++j, of_y *= y) {
    for (std::size_t i = 0; i + j < 5; ++i) powers_[i][j] += powers[i] * of_y;
    for (std::size_t i = 0; i + j < 3; ++i) products_[i][j] += products[i] * of_y;
  }
}

PatchMoments& PatchMoments::operator+=(const PatchMoments& other) {
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = 0; i + j < 5; ++j) powers_[i][j] += other.powers_[i][j];
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; i + j < 3; ++j) products_[i][j] += other.products_[i][j];
  squares_ += other.squares_;
  return *this;
}

/// Maximum a posteriori: least squares about the centre, where the sums do not cancel, with the prior as
/// readings of zero slope and curvature.
PatchFit PatchMoments::fit(const PatchPrior& prior) const {
  PatchFit patch;
  patch.x0_ = powers_[1][0] / count(), patch.y0_ = powers_[0][1] / count();
  const auto px = powers_of(-patch.x0_), py = powers_of(-patch.y0_);
  std::array<std::array<double, 5>, 5> about_centre{};
  for (int i = 0; i < 5; ++i)
    for (int j = 0; i + j < 5; ++j) about_centre[at(i)][at(j)] = shifted(powers_, i, j, px, py);
  Matrix6 normal;
  Vector6 right;
  for (int r = 0; r < 6; ++r) {
    const auto [ir, jr] = exponents[at(r)];
    for (int c = 0; c < 6; ++c) {
      const auto [ic, jc] = exponents[at(c)];
      normal(r, c) = about_centre[at(ir + ic)][at(jr + jc)];
    }
    right(r) = shifted(products_, ir, jr, px, py) - mean_q() * normal(0, r);
  }
  const Matrix6 unbiased = normal;
  const double variance = prior.reading_variance;
  const double slope = prior.slope / px_unit, curvature = prior.curvature / (px_unit * px_unit);
  normal(1, 1) += variance / (slope * slope), normal(2, 2) += variance / (slope * slope);
  // A term of x^2 is half the second derivative, one of xy all of it.
  normal(3, 3) += 4 * variance / (curvature * curvature),
      normal(5, 5) += 4 * variance / (curvature * curvature);
  normal(4, 4) += variance / (curvature * curvature);
  const Eigen::LDLT<Matrix6> solver(normal);
  const Vector6 terms = solver.solve(right);
  patch.squares_ = squares_ - count() * mean_q() * mean_q() + terms.dot(unbiased * terms - 2 * right);
  Eigen::Map<Vector6>(patch.terms_.data()) = terms;
  patch.terms_[0] += mean_q();
  Eigen::Map<Matrix6>(patch.covariance_.data()) = variance * solver.solve(Matrix6::Identity());
  return patch;
}

PatchPoint PatchFit::at(double x_px, double y_px) const {
  const double x = PatchMoments::px_unit * x_px - x0_, y = PatchMoments::px_unit * y_px - y0_;
  const auto& [c, cx, cy, cxx, cxy, cyy] = terms_;
  return {c + cx * x + cy * y + cxx * x * x + cxy * x * y + cyy * y * y,
          PatchMoments::px_unit * (cx + 2 * cxx * x + cxy * y),
          PatchMoments::px_unit * (cy + cxy * x + 2 * cyy * y)};
}

double PatchFit::q_at(double x_px, double y_px) const {
  const double x = PatchMoments::px_unit * x_px - x0_, y = PatchMoments::px_unit * y_px - y0_;
  const auto& [c, cx, cy, cxx, cxy, cyy] = terms_;
  return c + x * (cx + cxx * x + cxy * y) + y * (cy + cyy * y);
}

PatchFit::Variance PatchFit::variance_at(double x_px, double y_px) const {
  constexpr double unit = PatchMoments::px_unit;
  const double x = unit * x_px - x0_, y = unit * y_px - y0_;
  const Eigen::Map<const Matrix6> covariance(covariance_.data());
  const Vector6 value{{1, x, y, x * x, x * y, y * y}};
  const Vector6 slope_x{{0, unit, 0, 2 * unit * x, unit * y, 0}};
  const Vector6 slope_y{{0, 0, unit, 0, unit * x, 2 * unit * y}};
  return {value.dot(covariance * value),
          slope_x.dot(covariance * slope_x) + slope_y.dot(covariance * slope_y)};
}

}  // namespace facet
