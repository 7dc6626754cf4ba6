#include "synth/scene_truth.hpp"

#include <algorithm>
#include <set>

#include "synth/opposition.hpp"

namespace facet {
namespace {

struct FaceSum {
  int pixels = 0;
  Vec3d point;
};

std::vector<FaceSum> sum_faces(const Rendering& exact, const Camera& camera, std::size_t id_count) {
  std::vector<FaceSum> sums(id_count);
  for (int y = 0; y < exact.depth_m.height(); ++y) {
    for (int x = 0; x < exact.depth_m.width(); ++x) {
      FaceSum& sum = sums[exact.surface_ids(x, y)];
      ++sum.pixels;
      sum.point = sum.point + static_cast<double>(exact.depth_m(x, y)) * ray_direction(camera, x, y);
    }
  }
  return sums;
}

/// The plane of a flat face, from the patch that shows the surface id.
std::optional<Plane> plane_of(const PosedScene& posed, std::uint16_t surface_id) {
  for (const PosedPatch& p : posed.patches()) {
    if (p.object_id == 0 || (p.front_id != surface_id && p.back_id != surface_id)) continue;
    const double d = -dot(p.patch.frame.ez, p.patch.frame.origin);
    const double sign = d < 0 ? -1 : 1;  // towards the camera: n . P < 0, so d > 0
    return Plane{to_float(sign * p.patch.frame.ez), static_cast<float>(sign * d)};
  }
  return {};
}

}  // namespace

std::vector<TrueFace> true_faces(const Scene& scene, const PosedScene& posed, const Rendering& exact,
                                 const Camera& camera, const std::vector<TrueEdge>& edges) {
  std::vector<TrueFace> faces;
  const auto sums = sum_faces(exact, camera, first_face_id(scene, scene.objects.size()));
  for (std::size_t k = 0; k < scene.objects.size(); ++k) {
    const SceneObject& object = scene.objects[k];
    for (std::size_t f = 0; f < object.faces.size(); ++f) {
      const auto id = static_cast<std::uint16_t>(first_face_id(scene, k) + f);
      if (sums[id].pixels == 0) continue;
      TrueFace face{.surface_id = id, .object_id = static_cast<std::uint16_t>(k + 1)};
      face.name = object.shape + ", " + object.faces[f].name;
      face.curved = object.faces[f].curved;
      face.visible_px = sums[id].pixels;
      if (!face.curved) face.plane = plane_of(posed, id);
      face.centroid_m = to_float((1.0 / face.visible_px) * sums[id].point);
      face.graspable = has_opposing_edges(edges, id);
      faces.push_back(std::move(face));
    }
  }
  return faces;
}

SceneTruth scene_truth(const View& view, const PosedScene& posed, const Rendering& exact,
                       const Camera& camera, const EdgeWalk& walk) {
  SceneTruth truth;
  truth.edges = true_edges(view.scene, view.T_world_camera, posed, camera, exact.depth_m.size(), walk);
  truth.faces = true_faces(view.scene, posed, exact, camera, truth.edges);
  return truth;
}

void add_occlusion(SceneTruth& truth, const View& view, const Camera& camera, Size size) {
  for (std::size_t k = 0; k < view.scene.objects.size(); ++k) {
    Scene alone{.has_table = false, .has_room = false};
    alone.objects = {view.scene.objects[k]};
    const Rendering image = render(PosedScene(alone, view.T_world_camera), camera, size);
    std::vector<int> pixels(first_face_id(alone, 1));
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) ++pixels[image.surface_ids(x, y)];
    }
    const int first = first_face_id(view.scene, k), first_alone = first_face_id(alone, 0);
    for (TrueFace& face : truth.faces) {
      if (face.object_id != k + 1) continue;
      const int full = pixels[face.surface_id - first + first_alone];
      face.occluded_share = full > 0 ? std::max(0.0, 1.0 - static_cast<double>(face.visible_px) / full) : 0;
    }
  }
}

GraspCounts grasp_counts(const SceneTruth& truth, double factor) {
  GraspCounts counts;
  std::set<int> objects;
  for (const TrueFace& face : truth.faces) {
    if (!face.graspable || face.visible_px < factor * counted_face_px) continue;
    ++counts.surfaces;
    objects.insert(face.object_id);
  }
  counts.objects = static_cast<int>(objects.size());
  for (const TrueEdge& edge : truth.edges)
    counts.edges += edge.graspable && edge.length_px >= factor * counted_edge_px;
  return counts;
}

}  // namespace facet
