#include "synth/hull_overlap.hpp"

#include <algorithm>
#include <array>

namespace facet {
namespace {

Vec3d support(const Hull& hull, Vec3d direction) {
  const auto farthest = std::max_element(hull.points.begin(), hull.points.end(), [&](Vec3d p, Vec3d q) {
    return dot(p, direction) < dot(q, direction);
  });
  return *farthest;
}

/// Corners of the current simplex in the difference of the bodies, at most four, the newest first.
struct Simplex {
  std::array<Vec3d, 4> corners{};
  int count = 0;
};

/// The point nearest to the origin on the segment, triangle or tetrahedron; reduces the simplex to the part
/// it lies on. Ericson, Real-Time Collision Detection, section 5.1.
Vec3d nearest_on_segment(Simplex& s) {
  const Vec3d a = s.corners[0], ab = s.corners[1] - a;
  const double t = -dot(a, ab);
  if (t <= 0) {
    s.count = 1;
    return a;
  }
  const double length2 = dot(ab, ab);
  if (t >= length2) {
    s.corners[0] = s.corners[1];
    s.count = 1;
    return s.corners[0];
  }
  return a + (t / length2) * ab;
}

Vec3d nearest_on_triangle(Simplex& s) {
  const Vec3d a = s.corners[0], b = s.corners[1], c = s.corners[2];
  const Vec3d normal = cross(b - a, c - a);
  const auto outside = [&](Vec3d p, Vec3d q) { return dot(cross(q - p, normal), -p) > 0; };
  const bool flat = dot(normal, normal) < 1e-24;  // all on one line
  if (!flat && !outside(a, b) && !outside(b, c) && !outside(c, a))
    return (dot(a, normal) / dot(normal, normal)) * normal;
  double best = 1e300;
  Simplex best_simplex;
  Vec3d best_point;
  for (const auto& [p, q] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) {
    Simplex side{{p, q}, 2};
    const Vec3d point = nearest_on_segment(side);
    if (dot(point, point) < best) best = dot(point, point), best_simplex = side, best_point = point;
  }
  s = best_simplex;
  return best_point;
}

/// Zero where the origin lies inside.
Vec3d nearest_on_tetrahedron(Simplex& s) {
  const auto& c = s.corners;
  double best = 1e300;
  bool inside = true;
  Simplex best_simplex;
  Vec3d best_point;
  constexpr int faces[4][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 3, 2, 0}};
  for (const auto& f : faces) {
    const Vec3d normal = cross(c[f[1]] - c[f[0]], c[f[2]] - c[f[0]]);
    const double origin_side = dot(-c[f[0]], normal), inner_side = dot(c[f[3]] - c[f[0]], normal);
    if (origin_side * inner_side > 0) continue;
    inside = false;
    Simplex face{{c[f[0]], c[f[1]], c[f[2]]}, 3};
    const Vec3d point = nearest_on_triangle(face);
    if (dot(point, point) < best) best = dot(point, point), best_simplex = face, best_point = point;
  }
  if (inside) return {};
  s = best_simplex;
  return best_point;
}

Vec3d nearest(Simplex& s) {
  switch (s.count) {
    case 1:
      return s.corners[0];
    case 2:
      return nearest_on_segment(s);
    case 3:
      return nearest_on_triangle(s);
    default:
      return nearest_on_tetrahedron(s);
  }
}

/// Distance of the convex hulls of the points, 0 where they overlap.
double core_distance(const Hull& a, const Hull& b) {
  constexpr int iteration_limit = 64;
  Simplex simplex{{a.points[0] - b.points[0]}, 1};
  Vec3d point = simplex.corners[0];
  for (int k = 0; k < iteration_limit; ++k) {
    const double distance2 = dot(point, point);
    if (distance2 < 1e-16) return 0;
    const Vec3d next = support(a, -point) - support(b, point);
    if (distance2 - dot(point, next) < 1e-9 * distance2) break;  // no progress: this is the distance
    for (int i = simplex.count; i > 0; --i) simplex.corners[i] = simplex.corners[i - 1];
    simplex.corners[0] = next;
    ++simplex.count;
    point = nearest(simplex);
    if (simplex.count == 4) return 0;
  }
  return norm(point);
}

}  // namespace

bool hulls_overlap(const Hull& a, const Hull& b, double margin_m) {
  return core_distance(a, b) < a.radius_m + b.radius_m + margin_m;
}

std::vector<Hull> posed_hulls(const SceneObject& object) {
  std::vector<Hull> hulls = object.hulls;
  for (Hull& hull : hulls) {
    for (Vec3d& p : hull.points) p = object.pose.apply(p);
  }
  return hulls;
}

bool objects_overlap(const SceneObject& a, const SceneObject& b, double margin_m) {
  const std::vector<Hull> hulls_a = posed_hulls(a), hulls_b = posed_hulls(b);
  for (const Hull& p : hulls_a) {
    for (const Hull& q : hulls_b) {
      if (hulls_overlap(p, q, margin_m)) return true;
    }
  }
  return false;
}

}  // namespace facet
