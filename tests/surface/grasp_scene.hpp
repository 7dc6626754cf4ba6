#pragma once

#include <functional>

#include "core/edge_code.hpp"
#include "core/image.hpp"
#include "surface/contours.hpp"
#include "surface/grasp.hpp"
#include "surface/label_map.hpp"

namespace facet {

/// A frame with one face, seen against a floor far behind, whose outline is a graspable depth edge.
struct GraspScene {
  static constexpr Size size{320, 240};
  Camera camera{525, 525, 159.5f, 119.5f};
  Image<float> depth_m{size, 2.0f};
  Image<std::uint16_t> labels{size, 0};
  Image<std::uint8_t> edges{size, 0};
  std::vector<Surface> surfaces = numbered_surfaces(1);

  /// The face covers the pixels for which `inside` holds of the face's coordinates [m] on the plane, taken
  /// about its foot point on the optical axis.
  GraspScene(const Plane& plane, const std::function<bool(Vec2)>& inside) {
    const Vec3 origin{0, 0, -plane.d_m / plane.normal.z};
    const PlaneFrame frame(plane, camera, origin);
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) {
        const auto p = frame.from_image({static_cast<double>(x), static_cast<double>(y)});
        if (!p || !inside(*p)) continue;
        labels(x, y) = 1;
        depth_m(x, y) = frame.to_space(*p).z;
      }
    trace_regions(labels.view(), boxes_of(labels), surfaces);
    mark_outline(EdgeKind::depth, [](ContourPoint) { return true; });
    face().plane = plane;
    face().pose = pose_on_plane(plane, origin);
  }

  Surface& face() { return surfaces[0]; }
  void mark_outline(EdgeKind kind, const std::function<bool(ContourPoint)>& where) {
    for (const ContourPoint& p : face().contour.outer)
      if (where(p)) edges(p.x, p.y) = edge_code(kind, kind != EdgeKind::concave);
  }
  const std::vector<Grasp>& grasps(const GraspParams& params = {}) {
    GraspFinder().find({depth_m.view(), labels.view(), edges.view(), camera, kinect_v1_noise(), 1}, params,
                       face());
    return face().grasps;
  }
};

inline Plane facing_plane(float depth_m = 0.8f) {
  return {{0, 0, -1}, depth_m};
}
inline Plane tilted_plane() {
  const Vec3 normal = normalized({0.3f, -0.5f, -0.8f});
  return {normal, -dot(normal, {0, 0, 0.8f})};
}
/// A rectangle [m] turned by an angle about the middle.
inline std::function<bool(Vec2)> rectangle(double width_m, double height_m, double turn_deg = 0) {
  const double c = std::cos(turn_deg * M_PI / 180), s = std::sin(turn_deg * M_PI / 180);
  return [=](Vec2 p) {
    return std::fabs(c * p.x + s * p.y) <= width_m / 2 && std::fabs(c * p.y - s * p.x) <= height_m / 2;
  };
}
inline std::function<bool(Vec2)> disc(double diameter_m) {
  return [=](Vec2 p) { return norm(p) <= diameter_m / 2; };
}

}  // namespace facet
