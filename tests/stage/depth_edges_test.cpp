#include "stage/depth_edges.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <tuple>

#include "stage/gradient.hpp"
#include "support/analytic_depth.hpp"
#include "support/every_executor.hpp"
#include "support/masks.hpp"
#include "support/topology.hpp"

namespace facet {
namespace {

constexpr Camera camera{525, 525, 60, 45};
constexpr Size size{120, 90};
constexpr DepthNoise noise = {0.0012f, 0.0019f, 0.4f};

template <class Executor>
Mask jumps_of(Executor& executor, const Image<float>& depth) {
  Mask edge(depth.size(), 9);
  depth_jumps(executor, DepthEdgeParams{}, noise, depth.view(), edge.view());
  return edge;
}
Mask jumps_of(const Image<float>& depth) {
  CpuExecutor executor;
  return jumps_of(executor, depth);
}

template <class Executor>
std::tuple<Image<float>, Mask> strength_of(Executor& executor, const Image<float>& depth) {
  Image<float> gx(depth.size()), gy(depth.size());
  gradient(executor, {}, depth.view(), gx.view(), gy.view());
  std::tuple out{Image<float>(depth.size()), Mask(depth.size())};
  depth_gradient_strength(executor, depth.view(), std::as_const(gx).view(), std::as_const(gy).view(),
                          std::get<0>(out).view(), std::get<1>(out).view());
  return out;
}

/// A disc at 0.8 m, 20 pixels in radius, before a wall at 1 m.
bool on_disc(int x, int y) {
  return (x - 60) * (x - 60) + (y - 45) * (y - 45) <= 400;
}
Image<float> disc_scene() {
  return make_image<float>(size, [](int x, int y) { return on_disc(x, y) ? 0.8f : 1.0f; });
}

TEST(DepthJumps, MarkExactlyTheNearerSideOfAStep) {
  for (const float near_m : {0.6f, 0.9f, 0.97f}) {
    const auto step = make_image<float>(size, [&](int x, int) { return x < 50 ? near_m : 1.0f; });
    const auto expected = make_image<std::uint8_t>(size, [](int x, int) { return x == 49 ? 1 : 0; });
    EXPECT_TRUE(same_image(jumps_of(step), expected)) << near_m;
  }
}

TEST(DepthJumps, EncloseAnOccludingDiscFromItsOwnSide) {
  const Mask edge = jumps_of(disc_scene());
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const bool rim = on_disc(x, y) &&
                       !(on_disc(x - 1, y) && on_disc(x + 1, y) && on_disc(x, y - 1) && on_disc(x, y + 1));
      EXPECT_EQ(edge(x, y), rim) << x << ", " << y;
    }
  EXPECT_EQ(topology_of(edge).regions, 2);
}

TEST(DepthJumps, TakeNoSteepPlaneForAnEdge) {  // while it falls by less than the jump per pixel
  for (const double tilt_deg : {0.0, 30.0, 60.0, 75.0})
    for (const double azimuth_deg : {0.0, 45.0, 110.0, 270.0}) {
      const Vec3 n = tilted_normal(tilt_deg, azimuth_deg);
      const Image<float> plane = plane_depth(size, camera, n, static_cast<double>(n.z));
      EXPECT_EQ(count_set(jumps_of(plane)), 0) << tilt_deg << ", " << azimuth_deg;
    }
}

TEST(DepthJumps, AreFoundOnSteepPlanesToo) {
  const Vec3 n = tilted_normal(60, 0);
  const Image<float> far = plane_depth(size, camera, n, static_cast<double>(n.z));
  const auto scene =
      make_image<float>(size, [&](int x, int y) { return y < 45 ? far(x, y) - 0.1f : far(x, y); });
  const Mask edge = jumps_of(scene);
  for (int x = 3; x < 117; ++x) EXPECT_EQ(edge(x, 44), 1) << x;
}

TEST(DepthJumps, IgnoreStepsBelowTheNoise) {
  const float four_sigmas_m = 4 * noise.sigma_m(3);
  for (const float factor : {0.9f, 1.1f}) {
    const auto step =
        make_image<float>(size, [&](int x, int) { return x < 50 ? 3.0f : 3.0f + factor * four_sigmas_m; });
    EXPECT_EQ(count_set(jumps_of(step)), factor > 1 ? size.height : 0);
  }
}

TEST(DepthJumps, AreNotMadeByHoles) {
  const auto holes =
      make_image<float>(size, [](int x, int y) { return x % 9 == 4 && y % 7 == 3 ? 0.0f : 1.0f; });
  EXPECT_EQ(count_set(jumps_of(holes)), 0);
}

TEST(DepthGradientStrength, IsTheSameNearAndFar) {
  CpuExecutor executor;
  const Image<float> near = random_depth_without_holes(size, 3);
  const auto far = make_image<float>(size, [&](int x, int y) { return 4 * near(x, y); });
  EXPECT_TRUE(same_image(strength_of(executor, near), strength_of(executor, far)));
}

TEST(DepthGradientStrength, OfARampIsItsRelativeSlopeAlongTheRamp) {
  CpuExecutor executor;
  for (int i = 0; i < 4; ++i) {
    const Offset d = direction4(i);
    const auto ramp =
        make_image<float>(size, [&](int x, int y) { return 2 + 0.001 * (x * d.dx + y * d.dy); });
    const auto [strength, direction] = strength_of(executor, ramp);
    const double slope = 0.001 * std::hypot(d.dx, d.dy);
    EXPECT_NEAR(strength(60, 45), slope / static_cast<double>(ramp(60, 45)), 1e-6);
    EXPECT_EQ(direction(60, 45), i);
  }
}

TEST(DepthGradientStrength, IsZeroWhereDepthIsMissing) {
  CpuExecutor executor;
  const auto [strength, direction] = strength_of(executor, Image<float>(size));
  EXPECT_TRUE(same_image(strength, Image<float>(size)));
}

/// Both pixels of every step from disc to wall, as an edge map that does not know its side.
Mask both_sides() {
  return make_image<std::uint8_t>(size, [](int x, int y) {
    bool mixed = false;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) mixed |= on_disc(x + dx, y + dy) != on_disc(x, y);
    return mixed;
  });
}

template <class Executor>
Mask relocated(Executor& executor, const Image<float>& depth, const Mask& edge) {
  const auto [strength, direction] = strength_of(executor, depth);
  Mask out(depth.size(), 9);
  relocate_to_occluding_side(executor, depth.view(), direction.view(), edge.view(), out.view());
  return out;
}

TEST(RelocateToOccludingSide, MovesEveryEdgeOntoTheNearerSurface) {
  CpuExecutor executor;
  const Mask out = relocated(executor, disc_scene(), both_sides());
  EXPECT_GT(count_set(out), 100);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      if (out(x, y)) {
        EXPECT_TRUE(on_disc(x, y)) << x << ", " << y;
      }
}

TEST(RelocateToOccludingSide, LeavesEdgesOfFlatGroundWhereTheyAre) {
  CpuExecutor executor;
  const Mask edge = line_mask(size, 3);
  EXPECT_TRUE(same_image(relocated(executor, Image<float>(size, 1.0f), edge), edge));
}

TEST(RelocateToOccludingSide, KeepsAStraightEdgeOnePixelWide) {
  CpuExecutor executor;
  const auto step = make_image<float>(size, [](int x, int) { return x < 50 ? 1.2f : 1.0f; });
  for (const int column : {49, 50}) {
    const auto edge = make_image<std::uint8_t>(size, [&](int x, int) { return x == column; });
    const auto expected = make_image<std::uint8_t>(size, [](int x, int) { return x == 50; });
    EXPECT_TRUE(same_image(relocated(executor, step, edge), expected));
  }
}

TEST(DepthEdges, AreTheSameOnEveryExecutor) {
  for_each_awkward_depth([](const Image<float>& depth) {
    const Mask edge = line_mask(depth.size(), 2);
    expect_same_on_every_executor([&](auto& executor) { return jumps_of(executor, depth); });
    expect_same_on_every_executor([&](auto& executor) { return strength_of(executor, depth); });
    expect_same_on_every_executor([&](auto& executor) { return relocated(executor, depth, edge); });
  });
}

}  // namespace
}  // namespace facet
