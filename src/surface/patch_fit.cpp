#include "surface/patch_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>

namespace facet {
namespace {

constexpr std::array<std::array<int, 2>, 6> terms_of_fit{{{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}}};
constexpr std::array<std::array<double, 5>, 5> binomials{
    {{1, 0, 0, 0, 0}, {1, 1, 0, 0, 0}, {1, 2, 1, 0, 0}, {1, 3, 3, 1, 0}, {1, 4, 6, 4, 1}}};

/// Powers 0 to 4 of a number.
std::array<double, 5> powers_of(double v) {
  return {1, v, v * v, v * v * v, v * v * v * v};
}

/// Sum about another origin of x^i y^j, given the sums about the old one; px, py: powers of minus the way
/// there.
template <std::size_t n>
double shifted(const std::array<std::array<double, n>, n>& sums, int i, int j,
               const std::array<double, 5>& px, const std::array<double, 5>& py) {
  const auto at = [](int k) { return static_cast<std::size_t>(k); };
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

/// About the mean of x, y and q: what is left of the sums is of the order of the residuals.
template <int terms>
double PatchMoments::residual() const {
  const double n = count();
  if (n <= terms) return 0;
  const double mq = mean_q();
  const auto px = powers_of(-powers_[1][0] / n), py = powers_of(-powers_[0][1] / n);
  Eigen::Matrix<double, terms, terms> normal;
  Eigen::Matrix<double, terms, 1> right;
  for (int r = 0; r < terms; ++r) {
    const auto [ir, jr] = terms_of_fit[static_cast<std::size_t>(r)];
    for (int c = 0; c < terms; ++c) {
      const auto [ic, jc] = terms_of_fit[static_cast<std::size_t>(c)];
      normal(r, c) = shifted(powers_, ir + ic, jr + jc, px, py);
    }
    right(r) = shifted(products_, ir, jr, px, py) - mq * normal(0, r);
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
