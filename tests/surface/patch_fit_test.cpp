#include "surface/patch_fit.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "core/random.hpp"

namespace facet {
namespace {

constexpr PatchPrior vague{1e-8, 1e3, 1e3};

void add(PatchMoments& moments, double x_px, double y_px, double q) {
  moments.add_run(x_px, y_px, 1, [q](int) { return q; });
}

struct Patch {
  std::vector<Eigen::Vector3d> points;
  PatchMoments moments;
  double x = 0, y = 0;  ///< where it is
};

/// 300 noisy readings of a quadric over an area of 640 x 480 px times `span`.
Patch random_patch(std::uint64_t seed, double span) {
  Patch patch;
  patch.x = 250 * (random_uniform(seed, 3, 0) - 0.5), patch.y = 180 * (random_uniform(seed, 4, 0) - 0.5);
  for (std::uint64_t i = 0; i < 300; ++i) {
    const double x = patch.x + span * 640 * (random_uniform(seed, 1, i) - 0.5);
    const double y = patch.y + span * 480 * (random_uniform(seed, 2, i) - 0.5);
    const double noise = 0.006 * (random_uniform(seed, 5, i) - 0.5);
    patch.points.emplace_back(x, y, 1.2 + 1e-3 * x - 5e-4 * y + 2e-6 * x * y + 1e-6 * x * x + noise);
    add(patch.moments, x, y, patch.points.back().z());
  }
  return patch;
}

/// Least squares by Eigen's decomposition, about the place of the patch.
Eigen::VectorXd fit_by_eigen(const Patch& patch) {
  Eigen::MatrixXd a(patch.points.size(), 6);
  Eigen::VectorXd q(patch.points.size());
  for (std::size_t i = 0; i < patch.points.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const double x = patch.points[i].x() - patch.x, y = patch.points[i].y() - patch.y;
    a.row(row) << 1, x, y, x * x, x * y, y * y;
    q(row) = patch.points[i].z();
  }
  return a.colPivHouseholderQr().solve(q);
}

TEST(PatchFit, KnowsTheSquaresThatItLeaves) {
  for (const PatchPrior& prior : {vague, PatchPrior{1e-3, 1e-4, 1e-6}}) {
    const Patch patch = random_patch(7, 0.3);
    const PatchFit fit = patch.moments.fit(prior);
    double squares = 0;
    for (const Eigen::Vector3d& p : patch.points) {
      squares += std::pow(p.z() - fit.at(p.x(), p.y()).q, 2);
    }
    EXPECT_NEAR(fit.squares(), squares, 1e-9);
  }
}

TEST(PatchFit, WithoutAPriorIsEigensLeastSquares) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Patch patch = random_patch(seed, seed % 2 == 0 ? 1.0 : 0.06);
    const Eigen::VectorXd expected = fit_by_eigen(patch);
    const PatchFit fit = patch.moments.fit(vague);
    for (const double d : {-8.0, 0.0, 5.0}) {
      const double x = d, y = 2 - d;
      const PatchPoint p = fit.at(patch.x + x, patch.y + y);
      EXPECT_NEAR(p.q, expected.dot(Eigen::VectorXd{{1, x, y, x * x, x * y, y * y}}), 1e-6);
      EXPECT_NEAR(p.qx, expected.dot(Eigen::VectorXd{{0, 1, 0, 2 * x, y, 0}}), 1e-6);
      EXPECT_NEAR(p.qy, expected.dot(Eigen::VectorXd{{0, 0, 1, 0, x, 2 * y}}), 1e-6);
    }
  }
}

TEST(PatchFit, ItsVarianceIsThatOfManyFits) {
  constexpr double sigma = 0.004;
  const PatchPrior prior{sigma * sigma, 1e3, 1e3};
  double value = 0, slope = 0;
  constexpr int fits = 400;
  PatchFit last;
  for (std::uint64_t seed = 0; seed < fits; ++seed) {
    PatchMoments moments;
    for (int y = 0; y < 12; ++y)
      for (int x = 0; x < 16; ++x) {
        double normal_number = -6;
        for (std::uint64_t k = 0; k < 12; ++k)
          normal_number += random_uniform(seed, 9, 12 * static_cast<std::uint64_t>(y * 16 + x) + k);
        add(moments, x, y, 1 + 0.002 * x + sigma * normal_number);
      }
    last = moments.fit(prior);
    const PatchPoint p = last.at(15, 6);
    value += (p.q - 1.03) * (p.q - 1.03);
    slope += (p.qx - 0.002) * (p.qx - 0.002) + p.qy * p.qy;
  }
  const auto variance = last.variance_at(15, 6);
  EXPECT_NEAR(value / fits / variance.value, 1, 0.25);
  EXPECT_NEAR(slope / fits / variance.slope, 1, 0.25);
}

TEST(PatchFit, ThePriorMakesFewPixelsAFrontalPlaneAndManyWhatTheyAre) {
  const PatchPrior prior{1e-4, 0.003, 1e-5};
  PatchMoments few, many;
  for (int k = 0; k < 3; ++k) add(few, k, 0, 1 + 0.05 * k);
  for (int y = 0; y < 40; ++y) many.add_run(0, y, 40, [](int k) { return 1 + 0.05 * k; });
  EXPECT_LT(few.fit(prior).at(1, 0).qx, 0.01);
  EXPECT_NEAR(few.fit(prior).at(1, 0).q, 1.05, 1e-6);
  EXPECT_NEAR(many.fit(prior).at(20, 20).qx, 0.05, 1e-3);
}

TEST(PatchFit, OnePixelIsEnough) {
  PatchMoments one;
  add(one, 100, -50, 0.8);
  const PatchFit fit = one.fit({1e-5, 0.003, 1e-5});
  EXPECT_NEAR(fit.at(100, -50).q, 0.8, 1e-12);
  EXPECT_GT(fit.variance_at(120, -50).value, fit.variance_at(100, -50).value);
}

TEST(PatchMoments, TheSumsOfTwoPartsAreThoseOfTheWhole) {
  PatchMoments whole, left, right;
  for (int i = 0; i < 50; ++i) {
    const double x = i % 7, y = i / 7, q = 1 + 0.01 * x + 0.001 * i * i;
    add(whole, x, y, q);
    add(i < 20 ? left : right, x, y, q);
  }
  left += right;
  EXPECT_NEAR(left.fit(vague).at(3, 4).q, whole.fit(vague).at(3, 4).q, 1e-9);
  EXPECT_EQ(left.count(), whole.count());
  EXPECT_NEAR(left.mean_q(), whole.mean_q(), 1e-12);
}

TEST(PatchMoments, ARunIsItsPixelsOneByOne) {
  PatchMoments run, pixels;
  const auto q_at = [](int k) { return 1.1 + 0.01 * k * k; };
  for (int row = 0; row < 3; ++row) {
    run.add_run(-7.5, 30.5 + row, 20, q_at);
    for (int k = 0; k < 20; ++k) add(pixels, -7.5 + k, 30.5 + row, q_at(k));
  }
  EXPECT_EQ(run.count(), 60);
  EXPECT_NEAR(run.fit(vague).at(0, 31).q, pixels.fit(vague).at(0, 31).q, 1e-9);
  EXPECT_NEAR(run.fit(vague).at(0, 31).qx, pixels.fit(vague).at(0, 31).qx, 1e-9);
}

}  // namespace
}  // namespace facet
