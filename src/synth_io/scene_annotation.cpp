#include "synth_io/scene_annotation.hpp"

#include <nlohmann/json.hpp>

#include "synth/outline.hpp"

namespace facet {
namespace {

using Json = nlohmann::ordered_json;

Json numbers(Vec3 v) {
  return {v.x, v.y, v.z};
}

/// 4x4 matrix by rows.
Json matrix(const RigidMotion& m) {
  return {{m.ex.x, m.ey.x, m.ez.x, m.origin.x},
          {m.ex.y, m.ey.y, m.ez.y, m.origin.y},
          {m.ex.z, m.ey.z, m.ez.z, m.origin.z},
          {0, 0, 0, 1}};
}

/// The line without points that lie within 0.02 px of the chord of their neighbours.
ImagePath thinned(const ImagePath& line) {
  constexpr double tolerance_px = 0.02;
  ImagePath out{line.front()};
  std::size_t last = 0;
  for (std::size_t i = 2; i < line.size(); ++i) {
    const ImagePoint a = line[last], b = line[i];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    bool straight = length > 0;
    for (std::size_t k = last + 1; k < i && straight; ++k) {
      const double off = ((b.x - a.x) * (line[k].y - a.y) - (b.y - a.y) * (line[k].x - a.x)) / length;
      straight = std::abs(off) <= tolerance_px;
    }
    if (straight) continue;
    last = i - 1;
    out.push_back(line[last]);
  }
  out.push_back(line.back());
  return out;
}

ImagePath inside_image(ImagePath line, Size size) {
  for (ImagePoint& p : line) {
    p.x = std::clamp(p.x, -0.5, size.width - 0.5);
    p.y = std::clamp(p.y, -0.5, size.height - 0.5);
  }
  return line;
}

}  // namespace

Truth truth_of(const SceneTruth& scene, const Rendering& exact) {
  Truth truth{.size = exact.depth_m.size()};
  int order = 0;
  for (const TrueFace& face : scene.faces) {
    TruthSurface surface{.number = static_cast<int>(truth.surfaces.size()) + 1, .object = face.object_id};
    surface.graspable = face.graspable;
    surface.curved = face.curved;
    surface.description = face.name;
    for (ImagePath& path : outlines(exact.surface_ids, face.surface_id)) {
      surface.parts.push_back({std::move(path), order++});
    }
    truth.surfaces.push_back(std::move(surface));
  }
  for (const TrueEdge& edge : scene.edges) {
    TruthEdge out{
        .number = static_cast<int>(truth.edges.size()) + 1, .object = edge.object_id, .kind = edge.kind};
    out.graspable = edge.graspable;
    out.line = inside_image(thinned(edge.line), truth.size);
    truth.edges.push_back(std::move(out));
  }
  for (ImagePath& path : outlines(exact.surface_ids, table_surface_id)) {
    truth.support.push_back({std::move(path), order++});
  }
  return truth;
}

std::vector<TruePose> true_poses(const SceneTruth& scene) {
  std::vector<TruePose> poses;
  for (const TrueFace& face : scene.faces)
    poses.push_back({static_cast<int>(poses.size()) + 1, face.plane, face.centroid_m});
  return poses;
}

std::string geometry_text(const SceneTruth& scene, const PlannedPicture& picture) {
  Json faces = Json::array(), objects = Json::array();
  int number = 0;
  for (const TrueFace& face : scene.faces) {
    Json plane = nullptr;
    if (face.plane) plane = {{"normal", numbers(face.plane->normal)}, {"d_m", face.plane->d_m}};
    faces.push_back({{"surface", ++number},
                     {"object", face.object_id},
                     {"name", face.name},
                     {"visible_px", face.visible_px},
                     {"occluded_share", face.occluded_share},
                     {"plane", plane},
                     {"centroid_m", numbers(face.centroid_m)}});
  }
  const View& view = picture.view;
  for (std::size_t k = 0; k < view.scene.objects.size(); ++k) {
    objects.push_back({{"object", k + 1},
                       {"shape", view.scene.objects[k].shape},
                       {"T_world_object", matrix(view.scene.objects[k].pose)}});
  }
  const Json root{{"schema", 1},
                  {"objects_requested", picture.objects_requested},
                  {"T_world_camera", matrix(view.T_world_camera)},
                  {"surfaces", faces},
                  {"objects", objects}};
  return root.dump(1) + "\n";
}

}  // namespace facet
