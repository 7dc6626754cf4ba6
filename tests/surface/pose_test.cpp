#include "surface/pose.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>

#include "surface/regions.hpp"

namespace facet {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

const Camera camera{525, 525, 159.5f, 119.5f};

Vector3d eigen(Vec3 v) {
  return {v.x, v.y, v.z};
}

Matrix3d rotation_of(const SurfacePose& pose) {
  const auto& q = pose.quaternion_wxyz;
  return Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
}

SurfacePose pose_with_normal(Vec3 normal) {
  const Vec3 centre{0.1f, 0.2f, 1};
  const Vec3 n = normalized(normal);
  return pose_on_plane({n, -dot(n, centre)}, centre);
}

/// A frame with one surface: the pixels for which `inside` holds, at the depth of `depth_m`.
struct OneSurface {
  Image<float> depth_m{{320, 240}, 0.0f};
  Image<std::uint16_t> labels{{320, 240}, 0};
  RegionPixels pixels;
  std::vector<Surface> surfaces{1};

  OneSurface(const std::function<bool(int, int)>& inside, const std::function<float(float, float)>& depth) {
    for (int y = 0; y < 240; ++y)
      for (int x = 0; x < 320; ++x) {
        if (!inside(x, y)) continue;
        labels(x, y) = 1;
        depth_m(x, y) = depth(static_cast<float>(x), static_cast<float>(y));
      }
    pixels.collect(labels.view(), 1, depth_m.view(), Image<std::uint8_t>(labels.size(), 0).view(), camera,
                   1024);
    surfaces[0].id = 1;
    trace_regions(labels.view(), pixels.boxes, surfaces);
  }
  const Surface& estimate(const PoseParams& params = {}) {
    const PoseInput input{depth_m.view(), labels.view(), camera, kinect_v1_noise(), 1};
    estimate_pose(input, params, pixels.points[0], surfaces[0]);
    return surfaces[0];
  }
};

/// Depth along the ray of a pixel to the plane n . P + d = 0.
std::function<float(float, float)> depth_of(const Plane& plane) {
  return [plane](float x, float y) { return -plane.d_m / dot(plane.normal, camera.back_project(x, y, 1)); };
}
Plane plane_through(Vec3 normal, Vec3 point) {
  const Vec3 n = normalized(normal);
  return {n, -dot(n, point)};
}
bool on_label(const OneSurface& frame, Vec3 p) {
  const int x = static_cast<int>(std::lround(p.x / p.z * camera.fx + camera.cx));
  const int y = static_cast<int>(std::lround(p.y / p.z * camera.fy + camera.cy));
  return frame.labels.size().contains(x, y) && frame.labels(x, y) == 1;
}

TEST(PoseOnPlane, TheRotationsColumnsAreUpCrossNormalAndNormal) {
  for (const Vec3 n :
       {Vec3{0.3f, -0.5f, -0.8f}, Vec3{0, 0, -1}, Vec3{-0.9f, 0.1f, -0.4f}, Vec3{0.2f, 0.9f, -0.3f}}) {
    const Matrix3d r = rotation_of(pose_with_normal(n));
    const Vector3d z = eigen(normalized(n)), x = Vector3d(0, -1, 0).cross(z).normalized();
    EXPECT_LT((r.col(2) - z).norm(), 1e-5);
    EXPECT_LT((r.col(0) - x).norm(), 1e-5);
    EXPECT_LT((r.col(1) - z.cross(x)).norm(), 1e-5);
    EXPECT_NEAR(r.determinant(), 1, 1e-5);
  }
}

TEST(PoseOnPlane, TheCamerasXAxisIsUpWhereTheNormalIsNearlyVertical) {
  for (const float y : {-1.0f, 1.0f}) {
    const Vec3 n = normalized({0.1f, y, -0.2f});  // |n . up| = 0.976
    const Matrix3d r = rotation_of(pose_with_normal(n));
    const Vector3d x = Vector3d(1, 0, 0).cross(eigen(n)).normalized();
    EXPECT_LT((r.col(0) - x).norm(), 1e-5);
    EXPECT_NEAR(r.determinant(), 1, 1e-5);
  }
}

TEST(PoseOnPlane, TheSwitchOfUpIsAtACosineOf0_95) {
  const auto uses_y = [](float cosine) {
    const Vec3 n{0, -cosine, -std::sqrt(1 - cosine * cosine)};
    return std::fabs(rotation_of(pose_with_normal(n))(0, 0)) > 0.5;  // -Y x n is along X, X x n is not
  };
  EXPECT_TRUE(uses_y(0.94f));
  EXPECT_FALSE(uses_y(0.96f));
}

TEST(PoseOnPlane, TheQuaternionIsAUnitOneWithPositiveRealPart) {
  for (const Vec3 n :
       {Vec3{0.3f, -0.5f, -0.8f}, Vec3{0, 0, -1}, Vec3{-0.9f, 0.1f, -0.4f}, Vec3{0.01f, -1, -0.1f}}) {
    const auto& q = pose_with_normal(n).quaternion_wxyz;
    EXPECT_NEAR(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3], 1, 1e-5f);
    EXPECT_GE(q[0], 0);
  }
}

TEST(PoseOnPlane, TheZyxAnglesGiveTheSameRotation) {
  constexpr double radians = M_PI / 180;
  for (const Vec3 n : {Vec3{0.3f, -0.5f, -0.8f}, Vec3{-0.9f, 0.1f, -0.4f}, Vec3{0.2f, 0.9f, -0.3f}}) {
    const SurfacePose pose = pose_with_normal(n);
    const Matrix3d r = (Eigen::AngleAxisd(pose.zyx_deg[0] * radians, Vector3d::UnitZ()) *
                        Eigen::AngleAxisd(pose.zyx_deg[1] * radians, Vector3d::UnitY()) *
                        Eigen::AngleAxisd(pose.zyx_deg[2] * radians, Vector3d::UnitX()))
                           .toRotationMatrix();
    EXPECT_LT((r - rotation_of(pose)).norm(), 1e-4);
  }
}

TEST(RectangleAxis, IsTheDirectionOfTheLongSideInSpace) {
  const Plane plane = plane_through({0, 0, -1}, {0, 0, 1});
  for (const double turn_deg : {0.0, 30.0, 75.0, 120.0}) {
    const double c = std::cos(turn_deg * M_PI / 180), s = std::sin(turn_deg * M_PI / 180);
    Polyline outline;
    for (const auto& [u, v] : {std::pair{-60, -20}, {60, -20}, {60, 20}, {-60, 20}})
      outline.push_back({static_cast<int>(std::lround(160 + c * u - s * v)),
                         static_cast<int>(std::lround(120 + s * u + c * v))});
    const Vec3 axis = rectangle_axis(outline, plane, camera);
    EXPECT_NEAR(norm(axis), 1, 1e-5f);
    EXPECT_NEAR(dot(axis, plane.normal), 0, 1e-5f);
    EXPECT_GT(std::fabs(c * axis.x + s * axis.y), std::cos(1.5 * M_PI / 180)) << turn_deg;
  }
}

TEST(RectangleAxis, LiesInATiltedPlane) {
  const Plane plane = plane_through({0.2f, -0.8f, -0.5f}, {0, 0, 0.9f});
  const Vec3 axis = rectangle_axis({{100, 100}, {220, 100}, {220, 130}, {100, 130}}, plane, camera);
  EXPECT_NEAR(norm(axis), 1, 1e-5f);
  EXPECT_NEAR(dot(axis, plane.normal), 0, 1e-5f);
}

TEST(EstimatePose, ARectanglesCentreLiesInItsMiddleOnThePlane) {
  const Plane plane = plane_through({0, 0, -1}, {0, 0, 0.8f});
  OneSurface frame([](int x, int y) { return x >= 80 && x < 200 && y >= 60 && y < 140; }, depth_of(plane));
  const Surface& surface = frame.estimate();
  ASSERT_TRUE(surface.pose) << surface.no_pose_reason;
  EXPECT_EQ(surface.no_pose_reason, "");
  EXPECT_FALSE(surface.curved);
  const Vec3 middle = camera.back_project(139.5f, 99.5f, 0.8f);
  EXPECT_LT(norm(surface.pose->centre_m - middle), 0.002f);
  EXPECT_NEAR(surface.plane->signed_distance_m(surface.pose->centre_m), 0, 1e-5f);
}

TEST(EstimatePose, ARingsCentreLiesOnTheRing) {
  const Plane plane = plane_through({0, -0.6f, -0.8f}, {0, 0, 0.8f});
  OneSurface frame(
      [](int x, int y) {
        const int d2 = (x - 160) * (x - 160) + (y - 120) * (y - 120);
        return d2 <= 90 * 90 && d2 >= 60 * 60;
      },
      depth_of(plane));
  const Surface& surface = frame.estimate();
  ASSERT_TRUE(surface.pose) << surface.no_pose_reason;
  EXPECT_TRUE(on_label(frame, surface.pose->centre_m));
  EXPECT_NEAR(surface.plane->signed_distance_m(surface.pose->centre_m), 0, 1e-5f);
}

TEST(EstimatePose, ThePapersCentreIsThatOfTheContour) {
  const Plane plane = plane_through({0, 0, -1}, {0, 0, 0.8f});
  OneSurface frame([](int x, int y) { return x >= 80 && x < 200 && y >= 60 && y < 140; }, depth_of(plane));
  PoseParams params;
  params.centre = PoseCentre::contour;
  const Surface& surface = frame.estimate(params);
  ASSERT_TRUE(surface.pose);
  EXPECT_LT(norm(surface.pose->centre_m - camera.back_project(139.5f, 99.5f, 0.8f)), 0.001f);
}

TEST(EstimatePose, ThePapersCentreOfARingOverAHoleHasAReason) {
  const Plane plane = plane_through({0, 0, -1}, {0, 0, 0.8f});
  OneSurface frame(
      [](int x, int y) {
        const int d2 = (x - 160) * (x - 160) + (y - 120) * (y - 120);
        return d2 <= 90 * 90 && d2 >= 60 * 60;
      },
      depth_of(plane));
  PoseParams params;
  params.centre = PoseCentre::contour;
  const Surface& surface = frame.estimate(params);
  EXPECT_FALSE(surface.pose);
  EXPECT_TRUE(surface.plane);
  EXPECT_EQ(surface.no_pose_reason, "no depth at the contour's centre");
}

TEST(EstimatePose, ACylinderIsCurvedAndAPlaneIsNot) {
  // A standing cylinder of 5 cm radius whose axis is 0.8 m away.
  OneSurface cylinder([](int x, int y) { return x >= 130 && x < 190 && y >= 60 && y < 180; },
                      [](float x, float) {
                        const float u = (x - camera.cx) / camera.fx;
                        const float a = 1 + u * u, c = 0.8f * 0.8f - 0.05f * 0.05f;
                        return (0.8f - std::sqrt(0.8f * 0.8f - a * c)) / a;
                      });
  EXPECT_TRUE(cylinder.estimate().curved);
  EXPECT_LT(cylinder.estimate().inlier_share, 0.8f);
  OneSurface plane([](int x, int y) { return x >= 130 && x < 190 && y >= 60 && y < 180; },
                   depth_of(plane_through({0.5f, 0.2f, -0.8f}, {0, 0, 0.8f})));
  EXPECT_FALSE(plane.estimate().curved);
  EXPECT_GT(plane.estimate().inlier_share, 0.99f);
}

TEST(EstimatePose, IsTheSameTwice) {
  const auto inside = [](int x, int y) { return (x - 160) * (x - 160) + 2 * (y - 120) * (y - 120) < 5000; };
  const auto depth = [](float x, float y) { return 0.8f + 0.0001f * x + 0.002f * std::sin(37 * x + 91 * y); };
  OneSurface first(inside, depth), second(inside, depth);
  const Surface &a = first.estimate(), &b = second.estimate();
  ASSERT_TRUE(a.pose && b.pose);
  EXPECT_EQ(a.pose->centre_m, b.pose->centre_m);
  EXPECT_EQ(a.pose->quaternion_wxyz, b.pose->quaternion_wxyz);
  EXPECT_EQ(a.pose->rect_axis, b.pose->rect_axis);
}

TEST(EstimatePose, ASurfaceWithoutMeasuredPointsHasAReason) {
  OneSurface frame([](int x, int y) { return x < 10 && y < 10; }, [](float, float) { return 1.0f; });
  frame.pixels.points[0].resize(0);
  const Surface& surface = frame.estimate();
  EXPECT_FALSE(surface.pose);
  EXPECT_FALSE(surface.plane);
  EXPECT_EQ(surface.no_pose_reason, "fewer than 3 measured points");
}

}  // namespace
}  // namespace facet
