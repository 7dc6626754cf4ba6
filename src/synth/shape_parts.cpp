#include "synth/shape_parts.hpp"

#include "core/error.hpp"

namespace facet {
namespace {

Patch flat_patch(const std::vector<Vec3d>& corners, int face) {
  Patch patch{.shape = PatchShape::polygon, .front_surface = face};
  patch.frame.ex = normalized(corners[1] - corners[0]);
  patch.frame.ez = normalized(cross(corners[1] - corners[0], corners[2] - corners[0]));
  patch.frame.ey = cross(patch.frame.ez, patch.frame.ex);
  patch.frame.origin = corners[0];
  for (const Vec3d& corner : corners) patch.corners[patch.corner_count++] = patch.frame.unapply(corner);
  return patch;
}

/// Index of the face in which the edge runs from `b` to `a`: the neighbour of the face where it runs from a
/// to b.
int face_across(const std::vector<PolyhedronFace>& faces, Vec3d a, Vec3d b) {
  for (std::size_t k = 0; k < faces.size(); ++k) {
    const auto& corners = faces[k].corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (corners[i] == b && corners[(i + 1) % corners.size()] == a) return static_cast<int>(k);
    }
  }
  return -1;
}

}  // namespace

void require_positive(std::initializer_list<double> lengths_m, const char* shape) {
  for (double length : lengths_m) {
    if (!(length > 0)) throw Error(ErrorKind::config, std::string(shape) + ": every length must be positive");
  }
}

SceneObject make_polyhedron(const char* shape, const std::vector<PolyhedronFace>& faces) {
  SceneObject object{.shape = shape};
  Hull hull;
  for (std::size_t k = 0; k < faces.size(); ++k) {
    const auto& corners = faces[k].corners;
    const int index = static_cast<int>(k);
    object.faces.push_back({faces[k].name});
    object.patches.push_back(flat_patch(corners, index));
    hull.points.insert(hull.points.end(), corners.begin(), corners.end());
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec3d a = corners[i], b = corners[(i + 1) % corners.size()];
      const int other = face_across(faces, a, b);
      if (other < index) continue;  // listed with the other face
      object.curves.push_back({.start = a, .end = b, .patch_a = index, .patch_b = other});
    }
  }
  object.hulls = {hull};
  return object;
}

Patch disc_patch(double radius_m, double z_m, bool up, int face) {
  Patch patch{.shape = PatchShape::disc, .radius_m = radius_m, .front_surface = face};
  if (!up) patch.frame = rotation({1, 0, 0}, M_PI);
  patch.frame.origin = {0, 0, z_m};
  return patch;
}

Curve circle(double radius_m, double z_m, int patch_a, int patch_b) {
  Curve curve{.is_arc = true, .radius_m = radius_m, .patch_a = patch_a, .patch_b = patch_b};
  curve.frame.origin = {0, 0, z_m};
  return curve;
}

void add_ring(Hull& hull, double radius_m, double z_m) {
  constexpr int count = 24;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * M_PI * k / count;
    hull.points.push_back({radius_m * std::cos(angle), radius_m * std::sin(angle), z_m});
  }
}

}  // namespace facet
