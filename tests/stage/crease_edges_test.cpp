#include "stage/crease_edges.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <tuple>

#include "stage/gradient.hpp"
#include "support/analytic_depth.hpp"
#include "support/every_executor.hpp"
#include "support/masks.hpp"
#include "support/normal_planes.hpp"

namespace facet {
namespace {

constexpr Camera camera{525, 525, 60, 45};
constexpr Size size{120, 90};
using Strength = std::tuple<Image<float>, Mask>;

struct Inputs {
  Image<float> gx, gy, a, b, c;
  CreaseScratch scratch;
  Strength out;
  explicit Inputs(Size s)
      : gx(s),
        gy(s),
        a(s),
        b(s),
        c(s),
        scratch{a.view(), b.view(), c.view()},
        out{Image<float>(s), Mask(s)} {}
};

template <class Executor>
Strength direction_strength(Executor& executor, const CreaseParams& params, const Image<float>& depth) {
  Inputs in(depth.size());
  gradient(executor, {}, depth.view(), in.gx.view(), in.gy.view());
  direction_change(executor, params, gradient_noise_factor(GradientOperator::sobel), kinect_v1_noise(),
                   depth.view(), std::as_const(in.gx).view(), std::as_const(in.gy).view(), in.scratch,
                   std::get<0>(in.out).view(), std::get<1>(in.out).view());
  return in.out;
}
template <class Executor>
Strength gaussian_strength(Executor& executor, const Image<float>& depth) {
  Inputs in(depth.size());
  gradient(executor, {}, depth.view(), in.gx.view(), in.gy.view());
  curvature_gradient(executor, camera, depth.view(), std::as_const(in.gx).view(), std::as_const(in.gy).view(),
                     in.scratch, std::get<0>(in.out).view(), std::get<1>(in.out).view());
  return in.out;
}
template <class Executor>
Strength normal_strength(Executor& executor, const CreaseParams& params, const Image<Vec3>& normal,
                         const Mask& distance) {
  Strength out{Image<float>(normal.size()), Mask(normal.size())};
  normal_change(executor, params, NormalPlanes(normal).views(), distance.view(), std::get<0>(out).view(),
                std::get<1>(out).view());
  return out;
}

CreaseParams paper_params(CreaseAngle angle, bool weighted) {
  CreaseParams params;
  params.mode = CreaseMode::paper;
  params.angle = angle;
  params.weighted = weighted;
  return params;
}
Image<float> by_direction(const Image<float>& depth, CreaseAngle angle, bool weighted) {
  CpuExecutor executor;
  return std::get<0>(direction_strength(executor, paper_params(angle, weighted), depth));
}

/// Largest strength within two pixels of (x, y).
float largest_near(const Image<float>& strength, int x, int y) {
  float largest = 0;
  for (int dy = -2; dy <= 2; ++dy)
    for (int dx = -2; dx <= 2; ++dx) largest = std::max(largest, strength(x + dx, y + dy));
  return largest;
}

/// A camera pitched down by 35 degrees sees a table below, and a vertical box face above, which ends on the
/// table in row 45: depth falls downwards on the table and grows downwards on the face.
Image<float> table_before_box_face() {
  const Vec3 face = tilted_normal(35, -90), table = tilted_normal(55, 90);
  return nearer_of(plane_depth(size, camera, face, static_cast<double>(face.z)),
                   plane_depth(size, camera, table, static_cast<double>(table.z)));
}

TEST(DirectionChange, WithAtan2FindsTheCreaseBetweenATableTopAndAFrontalBoxFace) {
  const Image<float> strength = by_direction(table_before_box_face(), CreaseAngle::atan2, false);
  for (int x = 5; x < 115; ++x) EXPECT_NEAR(largest_near(strength, x, 45), 180, 1) << x;
}

TEST(DirectionChange, WithAtanAsPrintedMissesThatCreaseAsOppositeSlopesFold) {
  const Image<float> strength = by_direction(table_before_box_face(), CreaseAngle::atan, false);
  for (int x = 5; x < 115; ++x) EXPECT_LT(largest_near(strength, x, 45), 2) << x;
}

TEST(DirectionChange, CannotSeeACreaseBetweenSlopesOfTheSameDirection) {
  const Vec3 flat = tilted_normal(20, 90), steep = tilted_normal(60, 90);
  const Image<float> crease = farther_of(plane_depth(size, camera, flat, static_cast<double>(flat.z)),
                                         plane_depth(size, camera, steep, static_cast<double>(steep.z)));
  EXPECT_LT(largest_near(by_direction(crease, CreaseAngle::atan2, false), 60, 45), 2);
}

TEST(DirectionChange, OverAPlaneIsZero) {  // the direction of the gradient is the same all over a plane
  for (const double azimuth_deg : {0.0, 33.0, 90.0, 180.0, 250.0}) {
    const Vec3 n = tilted_normal(40, azimuth_deg);
    const Image<float> plane = plane_depth(size, camera, n, static_cast<double>(n.z));
    const Image<float> strength = by_direction(plane, CreaseAngle::atan2, false);
    for (int y = 2; y < 88; ++y)
      for (int x = 2; x < 118; ++x) EXPECT_LT(strength(x, y), 0.5f) << azimuth_deg;
  }
}

TEST(DirectionChange, EqualsTheTurnOfTheDirectionBetweenTwoPlanes) {
  const Vec3 left = tilted_normal(40, 20), right = tilted_normal(40, 80);
  const Image<float> crease = farther_of(plane_depth(size, camera, left, static_cast<double>(left.z)),
                                         plane_depth(size, camera, right, static_cast<double>(right.z)));
  // It crosses the crease at 60 degrees along x or y, or both: at least the turn, at most root two of it.
  const float strength = largest_near(by_direction(crease, CreaseAngle::atan2, false), 60, 45);
  EXPECT_GT(strength, 59);
  EXPECT_LT(strength, 60 * std::sqrt(2.0f) + 1);
}

TEST(DirectionChange, UnweightedFloodsFrontalNoiseAndWeightedDampsIt) {
  const auto noisy =
      make_image<float>(size, [](int x, int y) { return 1 + 0.003f * (noise_at(3, x, y) - 0.5f); });
  const auto share_above_low = [&](bool weighted) {
    const Image<float> strength = by_direction(noisy, CreaseAngle::atan2, weighted);
    int count = 0;
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) count += strength(x, y) > 25;
    return static_cast<double>(count) / static_cast<double>(size.area());
  };
  EXPECT_GT(share_above_low(false), 0.7);
  EXPECT_LT(share_above_low(true), 0.5 * share_above_low(false));
}

TEST(DirectionChange, IsZeroAcrossMissingPixels) {
  const Image<float> scene = table_before_box_face();
  auto column = make_image<float>({1, size.height}, [&](int, int y) { return scene(60, y); });
  EXPECT_NEAR(by_direction(column, CreaseAngle::atan2, false)(0, 45), 180, 1);
  column(0, 44) = 0;
  const Image<float> strength = by_direction(column, CreaseAngle::atan2, false);
  EXPECT_EQ(strength(0, 43), 0);
  EXPECT_EQ(strength(0, 45), 0);
}

/// The corner of a box that points at the camera: three faces, each at the same tilt.
Image<float> box_corner() {
  Image<float> depth(size);
  for (const double azimuth_deg : {90.0, 210.0, 330.0}) {
    const Vec3 face = tilted_normal(54.7356, azimuth_deg);
    depth = farther_of(depth, plane_depth(size, camera, face, static_cast<double>(face.z)));
  }
  return depth;
}
/// A ball of 3 cm that sits in a wall so that its cap meets it at 60 degrees.
Image<float> sunk_ball() {
  const Image<float> ball = sphere_depth(size, camera, {0, 0, 1.015f}, 0.03);
  return nearer_of(ball, Image<float>(size, 1.0f));
}
Image<float> by_gaussian(const Image<float>& depth) {
  CpuExecutor executor;
  return std::get<0>(gaussian_strength(executor, depth));
}

TEST(CurvatureGradient, VanishesOnAStraightCrease) {  // one principal curvature is zero there
  for (const double azimuth_deg : {0.0, 90.0}) {
    const Image<float> strength = by_gaussian(crease_depth(size, camera, 90, azimuth_deg, true));
    EXPECT_LT(largest_near(strength, 60, 45), 3) << "of a box edge of 90 degrees";
  }
}

TEST(CurvatureGradient, VanishesOnARoundedStraightCreaseInAnyDirection) {
  for (const double azimuth_deg : {20.0, 45.0, 70.0}) {
    const double c = std::cos(azimuth_deg * M_PI / 180), s = std::sin(azimuth_deg * M_PI / 180);
    const auto rounded = make_image<float>(
        size, [&](int x, int y) { return 1 + std::hypot((x - 60) * c + (y - 45) * s, 4.0) / 525; });
    EXPECT_LT(largest_near(by_gaussian(rounded), 60, 45), 1) << azimuth_deg;
  }
}

TEST(CurvatureGradient, IsLargeAtTheCornerOfABox) {
  EXPECT_GT(largest_near(by_gaussian(box_corner()), 60, 45), 20);
}

TEST(CurvatureGradient, IsLargeAtTheRimOfABall) {
  const int rim_px = static_cast<int>(525 * std::sqrt(0.03 * 0.03 - 0.015 * 0.015));
  const Image<float> strength = by_gaussian(sunk_ball());
  EXPECT_GT(largest_near(strength, 60 + rim_px, 45), 6);
  EXPECT_GT(largest_near(strength, 60, 45 - rim_px), 6);
}

TEST(CurvatureGradient, OfAPlaneIsZero) {
  const Vec3 n = tilted_normal(50, 30);
  const Image<float> strength = by_gaussian(plane_depth(size, camera, n, static_cast<double>(n.z)));
  for (int y = 3; y < 87; ++y)
    for (int x = 3; x < 117; ++x) EXPECT_LT(strength(x, y), 1);
}

/// Normals of two half planes that turn by `turn_deg` at column 60.
Image<Vec3> half_planes(float turn_deg) {
  Image<Vec3> normal(size);
  const float half = turn_deg / 2 / degrees_per_radian;
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      normal(x, y) = {(x < 60 ? -1 : 1) * std::sin(half), 0, -std::cos(half)};
  return normal;
}

TEST(NormalChange, IsTheChordOfTheAngleBetweenBothSides) {
  CpuExecutor executor;
  for (const float turn_deg : {0.0f, 10.0f, 30.0f, 90.0f, 150.0f}) {
    const auto [strength, direction] = normal_strength(executor, {}, half_planes(turn_deg), Mask(size, 5));
    for (int y = 10; y < 80; ++y) {
      EXPECT_NEAR(strength(60, y), 2 * std::sin(turn_deg / 2 / degrees_per_radian), 1e-5);
      EXPECT_NEAR(strength(30, y), 0, 1e-6);
      if (turn_deg > 0) {
        EXPECT_NE(direction(60, y), 2) << "across the crease, not along it";
      }
    }
  }
}

TEST(NormalChange, ReachesTheOffsetAndNoFarther) {
  const int offset = CreaseParams{}.radius_px;
  CpuExecutor executor;
  const Image<float> strength = std::get<0>(normal_strength(executor, {}, half_planes(90), Mask(size, 5)));
  for (int x = 20; x < 100; ++x) EXPECT_EQ(strength(x, 45) > 0.5f, x >= 60 - offset && x < 60 + offset) << x;
}

TEST(NormalChange, IsZeroWithinTheGuardAndWhereASideHasNoNormal) {
  CpuExecutor executor;
  const CreaseParams params;
  const Mask at_guard(size, static_cast<std::uint8_t>(params.depth_guard_px));
  EXPECT_TRUE(same_image(std::get<0>(normal_strength(executor, params, half_planes(90), at_guard)),
                         Image<float>(size)));
  EXPECT_TRUE(same_image(std::get<0>(normal_strength(executor, params, Image<Vec3>(size), Mask(size, 5))),
                         Image<float>(size)));
}

TEST(CreaseStrengths, AreTheSameOnEveryExecutor) {
  for_each_awkward_depth([](const Image<float>& depth) {
    for (const CreaseAngle angle : {CreaseAngle::atan2, CreaseAngle::atan})
      expect_same_on_every_executor(
          [&](auto& executor) { return direction_strength(executor, paper_params(angle, true), depth); });
    expect_same_on_every_executor([&](auto& executor) { return gaussian_strength(executor, depth); });
    Image<Vec3> normal(depth.size());
    for (int y = 0; y < depth.height(); ++y)
      for (int x = 0; x < depth.width(); ++x)
        if (depth(x, y) > 0) normal(x, y) = normalized({noise_at(1, x, y), noise_at(2, x, y), -1});
    const Mask distance = make_image<std::uint8_t>(depth.size(), [](int x, int y) { return (x + y) % 6; });
    expect_same_on_every_executor(
        [&](auto& executor) { return normal_strength(executor, {}, normal, distance); });
  });
}

}  // namespace
}  // namespace facet
