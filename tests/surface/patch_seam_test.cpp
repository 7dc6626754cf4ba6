#include "surface/patch_seam.hpp"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace facet {
namespace {

constexpr double focal_px = 500;
constexpr PatchPrior precise{1e-10, 10, 10};

/// Patch over 30 x 30 px, the first at (x0, -15), of the surface whose depth is given at metres to the right
/// per metre of depth.
PatchFit patch_of(const std::function<double(double)>& depth_m, int x0, const PatchPrior& prior = precise) {
  PatchMoments moments;
  for (int y = -15; y < 15; ++y)
    moments.add_run(x0, y, 30, [&](int k) { return 1 / depth_m((x0 + k) / focal_px); });
  return moments.fit(prior);
}

/// The plane through (0, 0, z0) whose normal is turned by `deg` about the vertical axis.
std::function<double(double)> turned(double deg, double z0) {
  return [=](double u) { return z0 / (1 - u * std::tan(deg * M_PI / 180)); };
}

Seam seam() {
  Seam seam;
  for (int y = -12; y < 13; y += 4) seam.add(0, static_cast<float>(y));
  return seam;
}

TEST(SeamDifference, IsTheAngleBetweenTwoPlanesOverWhatIsTolerated) {
  const PatchFit left = patch_of(turned(20, 0.9), -30), right = patch_of(turned(-10, 0.9), 0);
  const SeamTolerance tolerance{15 * M_PI / 180, 1, 0};
  const double chord = 2 * std::sin(15 * M_PI / 180);
  EXPECT_NEAR(seam_difference(left, right, seam(), focal_px, tolerance).excess, chord / (15 * M_PI / 180),
              1e-3);
}

TEST(SeamDifference, IsTheRelativeStepBetweenTwoPlanes) {
  const PatchFit left = patch_of(turned(0, 1.0), -30), right = patch_of(turned(0, 1.02), 0);
  EXPECT_NEAR(seam_difference(left, right, seam(), focal_px, {1, 0.01, 0}).excess, 0.02 / 1.01 * 1.01 / 0.01,
              0.02);
}

TEST(SeamDifference, VanishesAlongASmoothSurface) {
  const auto bowl = [](double u) { return 1.2 + 1.5 * u * u; };
  const PatchFit left = patch_of(bowl, -30), right = patch_of(bowl, 0);
  EXPECT_LT(seam_difference(left, right, seam(), focal_px, {15 * M_PI / 180, 0.005, 0}).excess, 0.1);
}

TEST(SeamDifference, ItsExcessShrinksWithTheNoiseOfTheFitsAndItsExpectationGrows) {
  const SeamTolerance tolerance{15 * M_PI / 180, 0.005, 3};
  SeamDifference before{1e9, 0};
  for (const double sigma : {1e-4, 1e-2, 1e-1}) {
    const PatchPrior prior{20 * sigma * sigma, 10, 10};
    const SeamDifference difference =
        seam_difference(patch_of(turned(20, 0.9), -30, prior), patch_of(turned(-20, 0.9), 0, prior), seam(),
                        focal_px, tolerance);
    EXPECT_LT(difference.excess, before.excess);
    EXPECT_GT(difference.expected, before.expected);
    before = difference;
  }
  EXPECT_LT(before.excess, 1);
}

}  // namespace
}  // namespace facet
