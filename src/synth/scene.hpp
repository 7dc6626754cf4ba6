#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "synth/curve.hpp"
#include "synth/patch.hpp"

namespace facet {

struct Rgb {
  std::uint8_t r = 0, g = 0, b = 0;
  friend bool operator==(const Rgb&, const Rgb&) = default;
};

/// A smooth face of an object.
struct Face {
  std::string name{};   ///< "top", "side", "inside" ...
  bool curved = false;  ///< not planar
};

/// Convex hull of points, grown by a radius: the room that a part of an object takes.
struct Hull {
  std::vector<Vec3d> points{};
  double radius_m = 0;
};

/// A solid or a thin-walled vessel. The object's frame has z up and its resting face in the plane z = 0.
struct SceneObject {
  std::string shape{};  ///< "box", "cylinder", ...
  std::vector<Patch> patches{};
  std::vector<Face> faces{};
  std::vector<Curve> curves{};  ///< where two patches meet at an angle, or a thin wall ends
  std::vector<Hull> hulls{};    ///< convex parts, for placing it
  RigidMotion pose{};           ///< object -> world
  Rgb colour{};
};

/// Objects on a table with a room behind. World frame: z up, table top in the plane z = 0. Metres.
struct Scene {
  std::vector<SceneObject> objects{};
  bool has_table = true;
  double table_half_width_m = 0.6;   ///< along world x
  double table_half_depth_m = 0.45;  ///< along world y
  bool has_room = true;              ///< a floor and a back wall
  double floor_z_m = -0.72;
  double wall_y_m = 1.9;
};

/// Values of the surface id image: 0 = room or nothing, `table_surface_id`, then the faces of the objects in
/// order: object k (from 0) has the ids first_face_id(scene, k) ... + faces.size() - 1.
inline constexpr std::uint16_t table_surface_id = 1;
inline std::uint16_t first_face_id(const Scene& scene, std::size_t object) {
  std::size_t id = table_surface_id + 1;
  for (std::size_t k = 0; k < object; ++k) id += scene.objects[k].faces.size();
  return static_cast<std::uint16_t>(id);
}

}  // namespace facet
