#include "surface/patch_fit.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <tuple>
#include <vector>

#include "core/random.hpp"

namespace facet {
namespace {

void add(PatchMoments& moments, double x_px, double y_px, double q) {
  moments.add_run(x_px, y_px, 1, [q](int) { return q; });
}

/// Residual of the least-squares fit with the first `terms` of 1, x, y, x^2, xy, y^2 by Eigen's
/// decomposition.
double residual_by_eigen(const std::vector<Eigen::Vector3d>& points, int terms) {
  Eigen::MatrixXd a(points.size(), 6);
  Eigen::VectorXd q(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const double x = points[i].x() / 100, y = points[i].y() / 100;
    a.row(row) << 1, x, y, x * x, x * y, y * y;
    q(row) = points[i].z();
  }
  const Eigen::MatrixXd used = a.leftCols(terms);
  return (used * used.colPivHouseholderQr().solve(q) - q).squaredNorm();
}

TEST(PatchMoments, ResidualsAreThoseOfEigensLeastSquares) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const double span = seed % 2 == 0 ? 1.0 : 0.06;  // the whole image, or a patch of 38 x 29 px
    const double at_x = 250 * (random_uniform(seed, 3, 0) - 0.5),
                 at_y = 180 * (random_uniform(seed, 4, 0) - 0.5);
    std::vector<Eigen::Vector3d> points;
    PatchMoments moments;
    for (std::uint64_t i = 0; i < 300; ++i) {
      const double x = at_x + span * 640 * (random_uniform(seed, 1, i) - 0.5);
      const double y = at_y + span * 480 * (random_uniform(seed, 2, i) - 0.5);
      const double noise = 0.006 * (random_uniform(seed, 5, i) - 0.5);
      const double q = 1.2 + 1e-3 * x - 5e-4 * y + 2e-6 * x * y + 1e-6 * x * x + noise;
      points.emplace_back(x, y, q);
      add(moments, x, y, q);
    }
    const double plane = residual_by_eigen(points, 3), quadric = residual_by_eigen(points, 6);
    EXPECT_NEAR(moments.plane_residual(), plane, 1e-6 * plane) << "seed " << seed;
    EXPECT_NEAR(moments.quadric_residual(), quadric, 1e-5 * quadric) << "seed " << seed;
    EXPECT_LE(moments.quadric_residual(), moments.plane_residual() * (1 + 1e-9));
  }
}

TEST(PatchMoments, TheSumsOfTwoPartsAreThoseOfTheWhole) {
  PatchMoments whole, left, right;
  for (int i = 0; i < 50; ++i) {
    const double x = i % 7, y = i / 7, q = 1 + 0.01 * x + 0.001 * i * i;
    add(whole, x, y, q);
    add(i < 20 ? left : right, x, y, q);
  }
  left += right;
  EXPECT_NEAR(left.plane_residual(), whole.plane_residual(), 1e-9);
  EXPECT_NEAR(left.quadric_residual(), whole.quadric_residual(), 1e-9);
  EXPECT_EQ(left.count(), whole.count());
  EXPECT_NEAR(left.mean_q(), whole.mean_q(), 1e-12);
}

TEST(PatchMoments, ARunIsItsPixelsOneByOne) {
  PatchMoments run, pixels;
  const auto q_at = [](int k) { return 1.1 + 0.01 * k * k; };
  run.add_run(-7.5, 30.5, 20, q_at);
  for (int k = 0; k < 20; ++k) add(pixels, -7.5 + k, 30.5, q_at(k));
  EXPECT_EQ(run.count(), 20);
  EXPECT_NEAR(run.plane_residual(), pixels.plane_residual(), 1e-12);
  EXPECT_NEAR(run.quadric_residual(), pixels.quadric_residual(), 1e-12);
}

TEST(PatchMoments, FewPixelsAndExactPatchesLeaveNothing) {
  PatchMoments few;
  for (const auto& [x, y, q] : {std::tuple{0.0, 0.0, 1.0}, {3.0, 1.0, 2.0}, {-2.0, 5.0, 0.5}}) {
    add(few, x, y, q);
    EXPECT_EQ(few.plane_residual(), 0);
    EXPECT_EQ(few.quadric_residual(), 0);
  }
  PatchMoments plane, bowl;
  for (int i = 0; i < 100; ++i) {
    const double x = i % 10, y = i / 10;
    add(plane, x, y, 1 + 0.02 * x - 0.01 * y);
    add(bowl, x, y, 1 + 0.02 * x + 0.003 * x * x - 0.002 * y * y);
  }
  EXPECT_NEAR(plane.plane_residual(), 0, 1e-9);
  EXPECT_NEAR(plane.quadric_residual(), 0, 1e-9);
  EXPECT_GT(bowl.plane_residual(), 0.01);
  EXPECT_NEAR(bowl.quadric_residual(), 0, 1e-9);
}

TEST(PatchMoments, PointsOnALineAreAllowed) {
  PatchMoments moments;
  for (int i = 0; i < 10; ++i) add(moments, i, 2 * i, 1);
  EXPECT_NEAR(moments.plane_residual(), 0, 1e-9);
  EXPECT_NEAR(moments.quadric_residual(), 0, 1e-9);
}

}  // namespace
}  // namespace facet
