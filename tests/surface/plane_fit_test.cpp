#include <cmath>
#include <gtest/gtest.h>

#include "core/random.hpp"
#include "surface/pose.hpp"

namespace facet {
namespace {

constexpr float degrees = 57.29577951f;

/// Sum of twelve uniform numbers: zero mean, unit variance.
float normal_number(std::uint64_t seed, std::uint64_t index) {
  float sum = -6;
  for (std::uint64_t i = 0; i < 12; ++i) sum += random_uniform(seed, 77, 12 * index + i);
  return sum;
}
float between(float low, float high, std::uint64_t seed, std::uint64_t stream, std::uint64_t index) {
  return low + (high - low) * random_uniform(seed, stream, index);
}

/// A plane with unit normal towards the camera through `through`.
Plane plane_of(Vec3 normal, Vec3 through) {
  normal = normalized(normal);
  if (dot(normal, through) > 0) normal = -normal;
  return {normal, -dot(normal, through)};
}

/// Points of a 20 x 20 cm patch of the plane, displaced along its normal by noise; the given share of them is
/// scattered in a box around it instead.
PointSample sample_of(const Plane& plane, Vec3 centre, float noise_m, float outlier_share, int count,
                      std::uint64_t seed) {
  const Vec3 side = std::fabs(plane.normal.x) < 0.9f ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 u = normalized(cross(side, plane.normal)), v = cross(plane.normal, u);
  PointSample points;
  for (int i = 0; i < count; ++i) {
    const auto k = static_cast<std::uint64_t>(i);
    const float a = between(-0.1f, 0.1f, seed, 1, k), b = between(-0.1f, 0.1f, seed, 2, k);
    const bool outlier = random_uniform(seed, 3, k) < outlier_share;
    const float off = outlier ? between(-0.1f, 0.1f, seed, 4, k) : noise_m * normal_number(seed, k);
    points.add(centre + a * u + b * v + off * plane.normal);
  }
  return points;
}

float angle_deg(Vec3 a, Vec3 b) {
  return degrees * std::atan2(norm(cross(a, b)), dot(a, b));
}

const Vec3 centre{0.1f, -0.05f, 0.9f};
const std::vector<Vec3> normals{{0, 0, -1}, {0, -1, -0.2f}, {0.7f, 0.1f, -0.7f}, {-0.9f, 0.3f, -0.3f}};

TEST(FitPlane, NoiseFreePointsGiveThePlaneItself) {
  for (const Vec3 n : normals) {
    const Plane truth = plane_of(n, centre);
    const PlaneFit fit = fit_plane(sample_of(truth, centre, 0, 0, 300, 1), {}, 0.004f, 1, 1);
    ASSERT_TRUE(fit.plane) << fit.reason;
    EXPECT_LT(angle_deg(fit.plane->normal, truth.normal), 0.01f);
    EXPECT_NEAR(fit.plane->d_m, truth.d_m, 1e-5f);
    EXPECT_FLOAT_EQ(fit.inlier_share, 1);
    EXPECT_LT(fit.rms_m, 1e-5f);
  }
}

// 600 good points with 1.5 mm noise over 20 cm: the normal's standard deviation is 0.0015 / (0.058 sqrt(600))
// = 0.06 degrees; the outliers that fall within the threshold add a little.
TEST(FitPlane, FortyPercentOutliersTurnTheNormalByLessThanHalfADegree) {
  for (const Vec3 n : normals)
    for (std::uint64_t seed = 0; seed < 25; ++seed) {
      const Plane truth = plane_of(n, centre);
      const PlaneFit fit =
          fit_plane(sample_of(truth, centre, 0.0015f, 0.4f, 1000, seed), {}, 0.0045f, seed, 1);
      ASSERT_TRUE(fit.plane) << fit.reason;
      EXPECT_LT(angle_deg(fit.plane->normal, truth.normal), 0.5f) << "seed " << seed;
      EXPECT_NEAR(fit.plane->signed_distance_m(centre), 0, 0.0005f) << "seed " << seed;
      EXPECT_NEAR(fit.inlier_share, 0.62f, 0.06f) << "seed " << seed;
    }
}

TEST(FitPlane, TheCentroidLiesOnThePlane) {
  const Plane truth = plane_of({0.3f, -0.8f, -0.6f}, centre);
  const PlaneFit fit = fit_plane(sample_of(truth, centre, 0.001f, 0.2f, 500, 3), {}, 0.004f, 1, 1);
  ASSERT_TRUE(fit.plane);
  EXPECT_NEAR(fit.plane->signed_distance_m(fit.centroid_m), 0, 1e-6f);
  EXPECT_LT(norm(fit.centroid_m - centre), 0.01f);
}

TEST(FitPlane, TheRmsIsThatOfTheNoise) {
  const Plane truth = plane_of({0, 0, -1}, centre);
  const PlaneFit fit = fit_plane(sample_of(truth, centre, 0.001f, 0, 4000, 5), {}, 0.01f, 1, 1);
  ASSERT_TRUE(fit.plane);
  EXPECT_NEAR(fit.rms_m, 0.001f, 0.00005f);
}

TEST(FitPlane, TheNormalPointsTowardsTheCamera) {
  for (const Vec3 n : normals) {
    const PlaneFit fit =
        fit_plane(sample_of(plane_of(n, centre), centre, 0.001f, 0, 200, 9), {}, 0.004f, 4, 2);
    ASSERT_TRUE(fit.plane);
    EXPECT_LT(dot(fit.plane->normal, centre), 0);
    EXPECT_GT(fit.plane->d_m, 0);
    EXPECT_NEAR(norm(fit.plane->normal), 1, 1e-5f);
  }
}

TEST(FitPlane, DependsOnSeedAndStreamAlone) {
  const Plane truth = plane_of({0.2f, 0.1f, -1}, centre);
  const PointSample points = sample_of(truth, centre, 0.0015f, 0.4f, 400, 11);
  const PlaneFit first = fit_plane(points, {}, 0.0045f, 7, 3), second = fit_plane(points, {}, 0.0045f, 7, 3);
  ASSERT_TRUE(first.plane && second.plane);
  EXPECT_EQ(first.plane->normal, second.plane->normal);
  EXPECT_EQ(first.plane->d_m, second.plane->d_m);
  const PlaneFit other = fit_plane(points, {}, 0.0045f, 8, 3);
  ASSERT_TRUE(other.plane);
  EXPECT_LT(angle_deg(other.plane->normal, first.plane->normal), 0.5f);
}

TEST(FitPlane, FewerThanThreePointsGiveAReason) {
  PointSample points;
  for (int i = 0; i < 3; ++i) {
    const PlaneFit fit = fit_plane(points, {}, 0.004f, 1, 1);
    EXPECT_FALSE(fit.plane);
    EXPECT_EQ(fit.reason, "fewer than 3 measured points");
    points.add({0.1f * static_cast<float>(i), 0, 1});
  }
}

TEST(FitPlane, CollinearPointsGiveAReason) {
  PointSample points;
  for (int i = 0; i < 50; ++i) points.add({0.01f * static_cast<float>(i), 0.02f * static_cast<float>(i), 1});
  const PlaneFit fit = fit_plane(points, {}, 0.004f, 1, 1);
  EXPECT_FALSE(fit.plane);
  EXPECT_EQ(fit.reason, "no three points span a plane");
}

TEST(FitPlane, CoincidentPointsGiveAReason) {
  PointSample points;
  for (int i = 0; i < 10; ++i) points.add({0.1f, 0.2f, 1});
  EXPECT_EQ(fit_plane(points, {}, 0.004f, 1, 1).reason, "no three points span a plane");
}

TEST(FitPlane, ThreePointsGiveTheirPlane) {
  PointSample points;
  for (const Vec3 p : {Vec3{0, 0, 1}, Vec3{0.1f, 0, 1}, Vec3{0, 0.1f, 1.1f}}) points.add(p);
  const PlaneFit fit = fit_plane(points, {}, 0.001f, 1, 1);
  ASSERT_TRUE(fit.plane) << fit.reason;
  EXPECT_LT(angle_deg(fit.plane->normal, {0, 1, -1}), 0.01f);
}

}  // namespace
}  // namespace facet
