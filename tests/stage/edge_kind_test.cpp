#include "stage/edge_kind.hpp"

#include <gtest/gtest.h>

#include "stage/gradient.hpp"
#include "support/analytic_depth.hpp"
#include "support/every_executor.hpp"
#include "support/masks.hpp"
#include "support/topology.hpp"

namespace facet {
namespace {

constexpr Camera camera{525, 525, 60, 45};
constexpr Size size{120, 90};
constexpr std::uint8_t none = 0, depth_edge_code = 17, convex_code = 18, concave_code = 3;
constexpr EdgeKindParams signed_test{Convexity::signed_test, 1};
constexpr EdgeKindParams printed{Convexity::hessian, 1};

template <class Executor>
Mask kinds_of(Executor& executor, const EdgeKindParams& params, const Image<float>& depth,
              const Mask& depth_edge, const Mask& edge) {
  Image<float> gx(depth.size()), gy(depth.size());
  gradient(executor, {}, depth.view(), gx.view(), gy.view());
  Mask copy = edge, code(depth.size(), 9);
  edge_kind(executor, params, camera, depth.view(), std::as_const(gx).view(), std::as_const(gy).view(),
            depth_edge.view(), copy.view(), code.view());
  return code;
}
/// Code of the crease pixel (60, 45) in a scene without depth edges.
std::uint8_t centre_code(const EdgeKindParams& params, const Image<float>& depth) {
  CpuExecutor executor;
  Mask edge(size);
  edge(60, 45) = 1;
  const Mask code = kinds_of(executor, params, depth, Mask(size), edge);
  EXPECT_EQ(count_set(code), 1);
  return code(60, 45);
}

TEST(EdgeKind, TellsConvexFromConcaveCreasesAtAnyAngleAndInAnyDirection) {
  for (const double turn_deg : {20.0, 45.0, 90.0, 120.0})
    for (const double azimuth_deg : {0.0, 30.0, 45.0, 90.0, 135.0, 160.0}) {
      EXPECT_EQ(centre_code(signed_test, crease_depth(size, camera, turn_deg, azimuth_deg, true)),
                convex_code)
          << turn_deg << ", " << azimuth_deg;
      EXPECT_EQ(centre_code(signed_test, crease_depth(size, camera, turn_deg, azimuth_deg, false)),
                concave_code)
          << turn_deg << ", " << azimuth_deg;
    }
}

TEST(EdgeKind, TellsThemApartOnTiltedBodies) {  // one face frontal, the other at a slant
  const Vec3 slanted = tilted_normal(60, 0);
  const Image<float> frontal(size, 1.0f),
      slope = plane_depth(size, camera, slanted, static_cast<double>(slanted.z));
  EXPECT_EQ(centre_code(signed_test, farther_of(frontal, slope)), convex_code);
  EXPECT_EQ(centre_code(signed_test, nearer_of(frontal, slope)), concave_code);
}

TEST(EdgeKind, OnASphereIsConvex) {
  EXPECT_EQ(centre_code(signed_test, sphere_depth(size, camera, {0, 0, 1}, 0.1)), convex_code);
}

TEST(EdgeKind, FromTable1AsPrintedCallsAConvexEdgeConcave) {  // for depth the sign of the Hessian is reversed
  EXPECT_EQ(centre_code(printed, crease_depth(size, camera, 90, 0, true)), concave_code);
  EXPECT_EQ(centre_code(printed, crease_depth(size, camera, 90, 0, false)), convex_code);
}

TEST(EdgeKind, FromTable1AsPrintedCallsABallConcave) {
  EXPECT_EQ(centre_code(printed, sphere_depth(size, camera, {0, 0, 1}, 0.1)), concave_code);
}

TEST(EdgeKind, OfAnUndecidedCreaseIsConcaveForWhichNoGraspIsClaimed) {
  EXPECT_EQ(centre_code(signed_test, Image<float>(size, 1.0f)), concave_code);
  EXPECT_EQ(centre_code(printed, Image<float>(size, 1.0f)), concave_code);
  const Image<float> valley = crease_depth(size, camera, 90, 0, false);
  EXPECT_EQ(centre_code({Convexity::hessian, 1000}, valley), concave_code) << "inside the dead band";
  EXPECT_EQ(centre_code(signed_test, Image<float>(size)), concave_code) << "no depth at all";
}

TEST(EdgeKind, OnOrBesideADepthEdgeIsDepthAndGraspable) {
  CpuExecutor executor;
  Mask depth_edge(size), edge(size, 1);
  depth_edge(40, 30) = 1;
  const Mask code =
      kinds_of(executor, signed_test, crease_depth(size, camera, 90, 0, true), depth_edge, edge);
  for (int y = 20; y < 40; ++y)
    for (int x = 30; x < 50; ++x)
      EXPECT_EQ(code(x, y) == depth_edge_code, std::abs(x - 40) <= 1 && std::abs(y - 30) <= 1);
}

TEST(EdgeKind, DoesNotLookAcrossADepthEdge) {
  // A valley whose left wall ends in a far drop three pixels away: only the samples before the drop count.
  Image<float> depth = crease_depth(size, camera, 90, 0, false);
  Mask depth_edge(size);
  for (int y = 0; y < size.height; ++y) {
    depth_edge(57, y) = 1;
    for (int x = 0; x < 57; ++x) depth(x, y) = 5;
  }
  Mask edge(size);
  edge(60, 45) = 1;
  CpuExecutor executor;
  EXPECT_EQ(kinds_of(executor, signed_test, depth, depth_edge, edge)(60, 45), concave_code);
}

TEST(EdgeKind, IsNoneOffTheEdges) {
  CpuExecutor executor;
  const Mask edge = line_mask(size, 4);
  const Mask code = kinds_of(executor, signed_test, random_depth(size, 2), random_mask(size, 3, 0.01f), edge);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) EXPECT_EQ(code(x, y) == none, edge(x, y) == 0);
}

TEST(EdgeKind, IsTheSameOnEveryExecutor) {
  for_each_awkward_depth([](const Image<float>& depth) {
    const Mask edge = line_mask(depth.size(), 2), depth_edge = random_mask(depth.size(), 3, 0.005f);
    for (const EdgeKindParams& params : {signed_test, printed})
      expect_same_on_every_executor(
          [&](auto& executor) { return kinds_of(executor, params, depth, depth_edge, edge); });
  });
}

}  // namespace
}  // namespace facet
