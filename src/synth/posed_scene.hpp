#pragma once

#include <optional>
#include <vector>

#include "core/camera.hpp"
#include "synth/scene.hpp"

namespace facet {

/// A patch in the camera frame with the ids that the images show.
struct PosedPatch {
  Patch patch{};
  std::uint16_t front_id = 0, back_id = 0;  ///< surface ids
  std::uint16_t object_id = 0;              ///< 0: table or room, k + 1: object k
  Rgb colour{};
};

/// What a ray sees first.
struct SceneHit {
  double depth_m = 0;  ///< along the optical axis
  std::size_t patch = 0;
  bool front = true;
  std::uint16_t surface_id = 0, object_id = 0;
  Vec3d point{};   ///< camera frame [m]
  Vec3d normal{};  ///< unit, towards the camera
};

/// A scene seen from a camera: every patch in the camera frame (x right, y down, z forward).
class PosedScene {
 public:
  /// Throws Error{config} where the camera is not above the table top or lies inside an object.
  PosedScene(const Scene& scene, const RigidMotion& T_world_camera);

  const std::vector<PosedPatch>& patches() const { return patches_; }
  /// First hit of the ray through the image point (x, y); pixel centres at integers. Nothing beyond
  /// `limit_m`.
  std::optional<SceneHit> cast(const Camera& camera, double x_px, double y_px, double limit_m = 1e9) const;
  /// First hit of the ray from `origin` (camera frame) along `direction`; depth_m is the multiple of
  /// `direction`.
  std::optional<SceneHit> cast_from(Vec3d origin, Vec3d direction, double limit) const;

 private:
  struct Bounds {
    Vec3d centre;
    double radius_m = 0;
  };
  void add(const Patch& patch, const PosedPatch& ids);
  void add_surroundings(const Scene& scene, const RigidMotion& T_camera_world);

  std::vector<PosedPatch> patches_;
  std::vector<Bounds> bounds_;
};

/// Direction of the ray through an image point, with z = 1.
inline Vec3d ray_direction(const Camera& camera, double x_px, double y_px) {
  return {(x_px - camera.cx) / camera.fx, (y_px - camera.cy) / camera.fy, 1};
}

/// The eight corners of a box around the patch, in the frame the patch is posed in.
std::array<Vec3d, 8> bounding_corners(const Patch& patch);

}  // namespace facet
