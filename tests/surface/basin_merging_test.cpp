#include "surface/basin_merging.hpp"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <map>
#include <set>

#include "core/camera.hpp"
#include "core/random.hpp"
#include "support/same_image.hpp"
#include "support/shuffled_grid.hpp"

namespace facet {
namespace {

constexpr Size size{96, 64};
constexpr double unit = 1.0 / 4194304;
const Camera camera{200, 200, 47.5f, 31.5f};

/// Sum of twelve uniform numbers: zero mean, unit variance.
double normal_number(std::uint64_t seed, std::uint64_t index) {
  double sum = -6;
  for (std::uint64_t i = 0; i < 12; ++i) sum += random_uniform(seed, 5, 12 * index + i);
  return sum;
}

/// The same basins, each named by its first pixel.
Image<std::int32_t> named_by_first_pixel(Image<std::int32_t> basin) {
  std::map<std::int32_t, std::int32_t> name;
  for (int y = 0; y < basin.height(); ++y)
    for (int x = 0; x < basin.width(); ++x)
      if (basin(x, y) >= 0) basin(x, y) = name.try_emplace(basin(x, y), y * basin.width() + x).first->second;
  return basin;
}

/// Depth of a scene cut into square basins, with the crease strength that an ideal normal fit would give: the
/// chord of the angle between the normals four pixels to the left and to the right.
struct Landscape {
  Image<std::int32_t> basin{size}, inverse_depth{size};
  Image<float> strength{size};

  Landscape(const std::function<double(double)>& depth_m,
            const std::function<double(double)>& normal_angle_rad, double noise_m, int basin_px) {
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) {
        const int index = y * size.width + x;
        basin(x, y) = y / basin_px * basin_px * size.width + x / basin_px * basin_px;
        const double z = depth_m(x) + noise_m * normal_number(3, static_cast<std::uint64_t>(index));
        inverse_depth(x, y) = static_cast<std::int32_t>(1 / z / unit);
        const double turn = normal_angle_rad(x + 4) - normal_angle_rad(x - 4);
        const double jitter = 0.03 * random_uniform(9, 9, static_cast<std::uint64_t>(index));
        strength(x, y) = static_cast<float>(2 * std::fabs(std::sin(turn / 2)) + jitter);
      }
  }
  Image<std::int32_t> merged(const MergeParams& params = {}, HostThreads&& threads = HostThreads()) const {
    Image<std::int32_t> region;
    const Image<std::int32_t> named = named_by_first_pixel(basin);
    BasinMerging().merge(threads, {named.view(), inverse_depth.view(), unit, strength.view(), 0.087f, camera},
                         params, kinect_v1_noise(), region);
    return region;
  }
};

int count_regions(const Image<std::int32_t>& region) {
  std::set<std::int32_t> names;
  for (int y = 0; y < region.height(); ++y)
    for (int x = 0; x < region.width(); ++x)
      if (region(x, y) >= 0) names.insert(region(x, y));
  return static_cast<int>(names.size());
}

/// Depth at column x of the plane through (0, z0) whose normal is turned by `angle` about the vertical axis.
double tilted_depth(double x, double z0_m, double angle_rad) {
  const double u = (x - static_cast<double>(camera.cx)) / static_cast<double>(camera.fx);
  return z0_m / (1 - u * std::tan(angle_rad));
}

Landscape roof(double crease_deg, double noise_m) {
  const double half = crease_deg / 2 * M_PI / 180;
  const auto angle = [half](double x) { return x < 48 ? half : -half; };
  return {[=](double x) { return tilted_depth(x, 0.8, angle(x)); }, angle, noise_m, 8};
}

TEST(BasinMerging, TwoPlanesThatMeetAt30DegreesStayTwo) {
  const Image<std::int32_t> region = roof(30, 0.001).merged();
  EXPECT_EQ(count_regions(region), 2);
  EXPECT_NE(region(10, 30), region(80, 30));
  EXPECT_EQ(region(10, 10), region(30, 60));
  EXPECT_EQ(region(60, 10), region(90, 60));
}

TEST(BasinMerging, OneNoisyPlaneBecomesOneRegion) {
  EXPECT_EQ(count_regions(roof(0, 0.002).merged()), 1);
  const auto tilt = [](double) { return 0.7; };
  const Landscape steep([](double x) { return tilted_depth(x, 0.8, 0.7); }, tilt, 0.002, 8);
  EXPECT_EQ(count_regions(steep.merged()), 1);
}

TEST(BasinMerging, ACylinderStaysOne) {
  const double radius = 0.08, axis = 0.8;
  const auto depth = [=](double x) {
    const double u = (x - static_cast<double>(camera.cx)) / static_cast<double>(camera.fx), a = 1 + u * u;
    const double root = axis * axis - a * (axis * axis - radius * radius);
    return (axis - std::sqrt(std::max(root, 1e-6))) / a;
  };
  const auto normal = [=](double x) {
    const double u = (x - static_cast<double>(camera.cx)) / static_cast<double>(camera.fx);
    return std::asin(std::clamp(u * depth(x) / radius, -1.0, 1.0));
  };
  // Only the middle, where the cylinder fills the image's columns.
  Landscape cylinder(depth, normal, 0.001, 8);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      if (x < 32 || x >= 64) cylinder.basin(x, y) = -1;
  EXPECT_EQ(count_regions(cylinder.merged()), 1);
}

/// A thin cylinder in the middle of the image, cut along its axis: half of it turns so fast that no plane
/// explains two neighbouring strips.
Landscape thin_cylinder(double strength_at_border) {
  const double radius = 0.03, axis = 0.6;
  const auto depth = [=](double x) {
    const double u = (x - static_cast<double>(camera.cx)) / static_cast<double>(camera.fx), a = 1 + u * u;
    const double root = axis * axis - a * (axis * axis - radius * radius);
    return (axis - std::sqrt(std::max(root, 1e-6))) / a;
  };
  Landscape cylinder(
      depth, [](double) { return 0.0; }, 0.0005, 12);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      if (x < 41 || x >= 55) cylinder.basin(x, y) = -1;
      cylinder.strength(x, y) = std::abs(x - 47) < 2 ? static_cast<float>(strength_at_border) : 0.1f;
    }
  return cylinder;
}

TEST(BasinMerging, ASmoothSurfaceStaysOneWherePatchesMayCurve) {
  MergeParams planes_alone;
  planes_alone.curve_radius_mm = 0;
  EXPECT_GT(count_regions(thin_cylinder(0.5).merged(planes_alone)), 1) << "what planes do not explain";
  EXPECT_EQ(count_regions(thin_cylinder(0.5).merged()), 1);
}

TEST(BasinMerging, TheAngleThatMakesACreaseIsAParameter) {
  MergeParams params;
  params.crease_deg = 40;
  params.step_ratio = 0.05f;  // one patch explains both to within 4 cm
  EXPECT_EQ(count_regions(roof(30, 0.001).merged(params)), 1);
}

TEST(BasinMerging, PlanesThatMeetInAStepStayTwo) {
  const auto step = [](double height_m) {
    return Landscape([=](double x) { return x < 48 ? 0.8 : 0.8 + height_m; }, [](double) { return 0.0; },
                     0.001, 8);
  };
  EXPECT_EQ(count_regions(step(0.012).merged()), 2);
  EXPECT_EQ(count_regions(step(0.001).merged()), 1);
}

TEST(BasinMerging, WhatIsWithinTheNoiseOfTheFitsIsNoCrease) {
  Landscape bumps = roof(30, 0.001);
  for (int y = 0; y < size.height; ++y)  // one basin of 2 x 2 px, far less than an independent reading
    for (int x = 0; x < size.width; ++x) bumps.basin(x, y) = x < 48 ? 0 : 48;
  bumps.basin(20, 20) = bumps.basin(21, 20) = bumps.basin(20, 21) = bumps.basin(21, 21) =
      20 * size.width + 20;
  bumps.inverse_depth(20, 20) += 10000;  // 2.4 mm/m^2
  EXPECT_EQ(count_regions(bumps.merged()), 2);
}

TEST(BasinMerging, AStrongBorderBetweenPartsOfOnePlaneIsNoCrease) {
  Landscape plane = roof(0, 0.001);
  for (int y = 0; y < size.height; ++y)
    for (int x = 46; x < 50; ++x) plane.strength(x, y) = 0.6f;
  EXPECT_EQ(count_regions(plane.merged()), 1);
}

TEST(BasinMerging, WhatIsNoBasinStaysSoAndSeparates) {
  Landscape plane = roof(0, 0.001);
  for (int y = 0; y < size.height; ++y) plane.basin(48, y) = -1;
  const Image<std::int32_t> region = plane.merged();
  EXPECT_EQ(count_regions(region), 2);
  EXPECT_EQ(region(48, 20), -1);
}

/// A flat board whose left half bends towards the camera by 15 cm: at the seam the two go on into each other,
/// but no one patch explains both.
TEST(BasinMerging, PatchesThatTouchSmoothlyButAreNotOneStayTwo) {
  const auto depth = [](double x) { return x < 48 ? 0.8 - 0.15 * std::pow((48 - x) / 48, 2) : 0.8; };
  Landscape scene(
      depth, [](double) { return 0.0; }, 0.0005, 8);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) scene.basin(x, y) = x < 48 ? 0 : 48;
  EXPECT_EQ(count_regions(scene.merged()), 2);
  MergeParams tolerant;
  tolerant.step_ratio = 0.02f;
  EXPECT_EQ(count_regions(scene.merged(tolerant)), 1);
}

TEST(BasinMerging, BordersMoveToTheCrease) {
  Landscape scene = roof(90, 0.001);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) scene.basin(x, y) = x < 44 + y / 8 % 2 * 8 ? 0 : 52;
  MergeParams still;
  still.border_moves_px = 0;
  const auto wrong = [&](const MergeParams& params) {
    const Image<std::int32_t> region = scene.merged(params);
    int count = 0;
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) count += region(x, y) != region(x < 48 ? 0 : 95, 0);
    return count;
  };
  EXPECT_EQ(wrong(still), 4 * size.height);
  EXPECT_LE(wrong({}), size.height);  // 1 px
}

TEST(BasinMerging, IsTheSameForAnyNumberOfThreads) {
  Landscape islands = roof(30, 0.003);
  for (int y = 0; y < size.height; ++y)
    for (const int barrier : {20, 70}) islands.basin(barrier, y) = -1;
  EXPECT_TRUE(same_image(islands.merged({}, ShuffledGridExecutor()), islands.merged()));
}

TEST(BasinMerging, IsTheSameForASecondFrame) {
  const Landscape scene = roof(30, 0.001), other = roof(0, 0.002);
  BasinMerging merging;
  HostThreads one_thread;
  Image<std::int32_t> region;
  for (const Landscape* l : {&scene, &other, &scene})
    merging.merge(one_thread,
                  {l->basin.view(), l->inverse_depth.view(), unit, l->strength.view(), 0.087f, camera}, {},
                  kinect_v1_noise(), region);
  const Image<std::int32_t> fresh = scene.merged();
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) ASSERT_EQ(region(x, y), fresh(x, y));
}

}  // namespace
}  // namespace facet
