#include "stage/normals.hpp"

#include <algorithm>
#include <gtest/gtest.h>

#include "support/analytic_depth.hpp"
#include "support/every_executor.hpp"
#include "support/masks.hpp"
#include "support/normal_planes.hpp"

namespace facet {
namespace {

constexpr Size size{160, 120};
constexpr Camera camera{525, 520, 70.3f, 64.8f};  // deliberately not the image's centre

template <class Executor>
Image<Vec3> normals_of(Executor& executor, const Image<float>& depth, const Mask& distance, int radius_px) {
  Image<std::int32_t> q(depth.size());
  NormalPlanes normal{Image<Vec3>(depth.size())};
  inverse_depth(executor, depth.view(), q.view());
  fit_normals(executor, radius_px, camera, std::as_const(q).view(), distance.view(), normal.views());
  return normal.vectors();
}
Image<Vec3> normals_of(const Image<float>& depth, const Mask& distance, int radius_px) {
  CpuExecutor executor;
  return normals_of(executor, depth, distance, radius_px);
}

/// Chessboard distance to the first pixel outside the image, capped.
Mask distance_to_border(Size s, int cap) {
  return make_image<std::uint8_t>(s, [&](int x, int y) {
    return std::min({cap, x + 1, y + 1, s.width - x, s.height - y});
  });
}

double degrees_between(Vec3 a, Vec3 b) {
  return static_cast<double>(norm(cross(a, b))) > 0 || dot(a, b) > 0
             ? std::atan2(static_cast<double>(norm(cross(a, b))), static_cast<double>(dot(a, b))) * 180 / M_PI
             : 180;
}

TEST(Normals, OfAPlaneAreExactAtEveryTiltAndEveryPixel) {
  for (const double tilt_deg : {0.0, 10.0, 30.0, 45.0, 60.0, 70.0, 80.0})
    for (const double azimuth_deg : {0.0, 50.0, 90.0, 200.0, 315.0}) {
      const Vec3 away = tilted_normal(tilt_deg, azimuth_deg);
      const Image<float> depth = plane_depth(size, camera, away, static_cast<double>(away.z));
      const Image<Vec3> normal = normals_of(depth, distance_to_border(size, 5), 4);
      for (int y = 4; y < size.height - 4; y += 3)
        for (int x = 4; x < size.width - 4; x += 3)
          if (depth(x, y) < 5 && depth(x, y) > 0) {  // near the horizon a unit of inverse depth is coarse
            EXPECT_LT(degrees_between(normal(x, y), -away), 0.02) << tilt_deg << ", " << azimuth_deg;
          }
    }
}

TEST(Normals, AreUnitVectorsTowardsTheCamera) {
  const Image<float> depth = random_depth_without_holes(size, 4);
  const Image<Vec3> normal = normals_of(depth, distance_to_border(size, 3), 2);
  for (int y = 2; y < size.height - 2; ++y)
    for (int x = 2; x < size.width - 2; ++x) {
      const Vec3 n = normal(x, y);
      EXPECT_NEAR(norm(n), 1, 1e-5);
    }
  const Vec3 away = tilted_normal(75, 20);
  const Image<float> plane = plane_depth(size, camera, away, static_cast<double>(away.z));
  const Image<Vec3> towards = normals_of(plane, distance_to_border(size, 5), 4);
  for (int y = 4; y < size.height - 4; ++y)
    for (int x = 4; x < size.width - 4; ++x) {
      const Vec3 p = camera.back_project(static_cast<float>(x), static_cast<float>(y), plane(x, y));
      EXPECT_LT(dot(towards(x, y), p), 0);
    }
}

TEST(Normals, OfASpherePointAlongItsRadius) {
  const Vec3 centre{0.05f, -0.02f, 1.0f};
  const Image<float> depth = sphere_depth(size, camera, centre, 0.1);
  const Image<Vec3> normal = normals_of(depth, distance_to_border(size, 4), 3);
  int checked = 0;
  for (int y = 4; y < size.height - 4; ++y)
    for (int x = 4; x < size.width - 4; ++x) {
      const Vec3 radial =
          normalized(camera.back_project(static_cast<float>(x), static_cast<float>(y), depth(x, y)) - centre);
      if (depth(x, y) == 0 || radial.z > -0.7f) continue;  // away from the outline
      EXPECT_LT(degrees_between(normal(x, y), radial), 0.5);
      ++checked;
    }
  EXPECT_GT(checked, 1000);
}

/// The wanted distances, less where the image's border is nearer.
template <class Distance>
Mask within_image(const Distance& wanted) {
  const Mask room = distance_to_border(size, 255);
  return make_image<std::uint8_t>(size,
                                  [&](int x, int y) { return std::min<int>(room(x, y), wanted(x, y)); });
}

TEST(Normals, NeedAWindowOfFiveByFive) {
  const Image<float> depth(size, 1.0f);
  const Mask strips = within_image([](int x, int) { return x / 40; });  // distance 0, 1, 2, 3
  const Image<Vec3> normal = normals_of(depth, strips, 4);
  EXPECT_EQ(normal(20, 60), Vec3{});
  EXPECT_EQ(normal(60, 60), Vec3{});
  EXPECT_EQ(normal(100, 60), Vec3{});
  EXPECT_NEAR(norm(normal(140, 60)), 1, 1e-5);
}

TEST(Normals, OfRadiusOneAreFittedToThreeByThree) {
  const Image<float> depth(size, 1.0f);
  const auto all = [](int distance) { return within_image([&](int, int) { return distance; }); };
  EXPECT_NEAR(norm(normals_of(depth, all(2), 1)(60, 60)), 1, 1e-5);
  EXPECT_EQ(normals_of(depth, all(1), 1)(60, 60), Vec3{});
}

TEST(Normals, LookNoFartherThanTheDistanceAllows) {
  auto depth = make_image<float>(size, [](int x, int) { return x < 80 ? 1.0f : 1.5f; });
  const auto distance = make_image<std::uint8_t>(size, [](int x, int y) {
    const int to_step = x < 80 ? 80 - x : x - 79;
    return std::min({5, to_step, x + 1, y + 1, 160 - x, 120 - y});
  });
  const Image<Vec3> normal = normals_of(depth, distance, 4);
  for (int x = 4; x < 156; ++x)
    if (distance(x, 60) >= 3) {
      EXPECT_LT(degrees_between(normal(x, 60), {0, 0, -1}), 0.02) << x;
    }
}

TEST(InverseDepth, IsWithinHalfAUnitAndZeroWhereMissing) {
  const auto depth = make_image<float>({64, 1}, [](int x, int) { return x == 0 ? 0.0 : 0.25 + 0.1 * x; });
  Image<std::int32_t> q(depth.size());
  CpuExecutor executor;
  inverse_depth(executor, depth.view(), q.view());
  EXPECT_EQ(q(0, 0), 0);
  for (int x = 1; x < 64; ++x) EXPECT_NEAR(q(x, 0), 4194304.0 / static_cast<double>(depth(x, 0)), 1.01);
}

TEST(Normals, AreTheSameOnEveryExecutor) {
  for_each_awkward_depth([](const Image<float>& depth) {
    const Mask distance = distance_to_border(depth.size(), 5);
    expect_same_on_every_executor([&](auto& executor) { return normals_of(executor, depth, distance, 4); });
  });
}

}  // namespace
}  // namespace facet
