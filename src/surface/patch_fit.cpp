#include "surface/patch_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace facet {
namespace {

/// Lengths in hundreds of pixels, so that all powers are of one order.
constexpr double px_unit = 0.01;

constexpr std::array<std::array<int, 2>, 6> terms_of_fit{{{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}}};
constexpr std::array<std::array<double, 5>, 5> binomials{
    {{1, 0, 0, 0, 0}, {1, 1, 0, 0, 0}, {1, 2, 1, 0, 0}, {1, 3, 3, 1, 0}, {1, 4, 6, 4, 1}}};

/// Sums about another origin (mx, my): of x^i y^j, given those about the old one.
template <std::size_t n>
double shifted(const std::array<std::array<double, n>, n>& sums, int i, int j, double mx, double my) {
  double total = 0;
  for (int a = 0; a <= i; ++a)
    for (int b = 0; b <= j; ++b)
      total += binomials[static_cast<std::size_t>(i)][static_cast<std::size_t>(a)] *
               binomials[static_cast<std::size_t>(j)][static_cast<std::size_t>(b)] * std::pow(-mx, i - a) *
               std::pow(-my, j - b) * sums[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
  return total;
}

}  // namespace

void PatchMoments::add(double x_px, double y_px, double q) {
  const double x = px_unit * x_px, y = px_unit * y_px;
  const std::array<double, 5> px{1, x, x * x, x * x * x, x * x * x * x};
  const std::array<double, 5> py{1, y, y * y, y * y * y, y * y * y * y};
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = 0; i + j < 5; ++j) powers_[i][j] += px[i] * py[j];
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; i + j < 3; ++j) products_[i][j] += q * px[i] * py[j];
  squares_ += q * q;
}

PatchMoments& PatchMoments::operator+=(const PatchMoments& other) {
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = 0; i + j < 5; ++j) powers_[i][j] += other.powers_[i][j];
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; i + j < 3; ++j) products_[i][j] += other.products_[i][j];
  squares_ += other.squares_;
  return *this;
}

/// About the mean of x, y and q: what is left of the sums is of the order of the residuals.
template <int terms>
double PatchMoments::residual() const {
  const double n = count();
  if (n <= terms) return 0;
  const double mx = powers_[1][0] / n, my = powers_[0][1] / n, mq = mean_q();
  Eigen::Matrix<double, terms, terms> normal;
  Eigen::Matrix<double, terms, 1> right;
  for (int r = 0; r < terms; ++r) {
    const auto [ir, jr] = terms_of_fit[static_cast<std::size_t>(r)];
    for (int c = 0; c < terms; ++c) {
      const auto [ic, jc] = terms_of_fit[static_cast<std::size_t>(c)];
      normal(r, c) = shifted(powers_, ir + ic, jr + jc, mx, my);
    }
    right(r) = shifted(products_, ir, jr, mx, my) - mq * normal(0, r);
  }
  const double spread = squares_ - n * mq * mq;
  const Eigen::Matrix<double, terms, 1> fit = normal.completeOrthogonalDecomposition().solve(right);
  return std::max(0.0, spread - fit.dot(right));
}

double PatchMoments::plane_residual() const {
  return residual<3>();
}
double PatchMoments::quadric_residual() const {
  return residual<6>();
}

}  // namespace facet
