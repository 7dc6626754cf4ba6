#include "synth/edge_probe.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace facet {
namespace {

/// Depth at which the ray through `image` meets the plane through `hit` with its normal.
double plane_depth(const SceneHit& hit, const Camera& camera, ImagePoint image) {
  const double along = dot(hit.normal, ray_direction(camera, image.x, image.y));
  return std::abs(along) > 1e-9 ? dot(hit.normal, hit.point) / along : 1e9;
}

ImagePoint beside(const CurvePoint& at, double offset_px) {
  return {at.image.x - offset_px * at.tangent.y, at.image.y + offset_px * at.tangent.x};
}

/// The ray hit a patch that ends at the point, and did so right there rather than on its far side.
bool continues(const PosedScene& scene, const SceneHit& hit, const Camera& camera, const CurvePoint& at,
               double offset_px) {
  if (hit.patch != at.patch_a && hit.patch != at.patch_b) return false;
  const Patch& patch = scene.patches()[hit.patch].patch;
  const double step_m = offset_px * at.point.z / camera.fx;
  const double radius = std::max(patch.radius_m, patch.end_radius_m);
  const bool flat = patch.shape == PatchShape::polygon || patch.shape == PatchShape::disc;
  if (flat) return std::abs(plane_depth(hit, camera, at.image) - at.point.z) < 1e-6;
  // Near a silhouette the depth falls off as the root of the distance from it.
  return std::abs(hit.depth_m - at.point.z) < 1e-4 + 8 * step_m + 2 * std::sqrt(2 * radius * step_m);
}

struct Side {
  std::optional<SceneHit> hit;
  bool own = false;
  double step_m =
      0;  ///< depth of what is seen on this side, continued to the point, less the depth of the point
};

Side look(const PosedScene& scene, const Camera& camera, const CurvePoint& at, double offset_px) {
  const ImagePoint image = beside(at, offset_px);
  Side side{.hit = scene.cast(camera, image.x, image.y)};
  side.step_m = 1e9;
  if (!side.hit) return side;
  side.own = continues(scene, *side.hit, camera, at, std::abs(offset_px));
  side.step_m = side.own ? 0 : plane_depth(*side.hit, camera, at.image) - at.point.z;
  return side;
}

EdgeKind crease_kind(const SceneHit& a, const SceneHit& b, const ProbeRule& rule) {
  if (dot(a.normal, b.normal) > rule.crease_min_cos) return EdgeKind::none;
  return dot(b.point - a.point, b.normal - a.normal) > 0 ? EdgeKind::convex : EdgeKind::concave;
}

/// Room for a finger on one side of the edge: beside a depth edge everything up to a finger's thickness lies
/// behind the edge; beside a crease no other object covers the face.
bool has_room(const PosedScene& scene, const Camera& camera, const CurvePoint& at, double direction,
              const Side& side, std::uint16_t owner, const ProbeRule& rule) {
  for (const double share : {0.5, 1.0}) {
    const double offset = direction * share * rule.finger_m * camera.fx / at.point.z;
    const ImagePoint image = beside(at, offset);
    const auto hit = scene.cast(camera, image.x, image.y);
    if (!hit) continue;
    if (!side.own) {
      if (hit->depth_m < at.point.z + rule.finger_depth_m) return false;
    } else if (hit->object_id != owner &&
               hit->depth_m <
                   std::min(plane_depth(*side.hit, camera, image), at.point.z) - rule.contact_gap_m) {
      return false;
    }
  }
  return true;
}

}  // namespace

EdgeSample probe_edge(const PosedScene& scene, const Camera& camera, const CurvePoint& at,
                      const ProbeRule& rule) {
  const std::array<Side, 2> sides{look(scene, camera, at, rule.offset_px),
                                  look(scene, camera, at, -rule.offset_px)};
  EdgeSample sample;
  if (!sides[0].own && !sides[1].own) return sample;
  sample.own_on_side = {sides[0].own, sides[1].own};
  const std::uint16_t owner = scene.patches()[at.patch_a].object_id;
  if (sides[0].own && sides[1].own) {
    if (sides[0].hit->surface_id == sides[1].hit->surface_id) return sample;
    sample.kind = crease_kind(*sides[0].hit, *sides[1].hit, rule);
    sample.own = {sides[0].hit->surface_id, sides[1].hit->surface_id};
    sample.first_face_right = sample.own[0] < sample.own[1];
    sample.own_normals = {sides[0].hit->normal, sides[1].hit->normal};
    if (!sample.first_face_right) {
      std::swap(sample.own[0], sample.own[1]);
      std::swap(sample.own_normals[0], sample.own_normals[1]);
    }
  } else {
    const int own = sides[0].own ? 0 : 1;
    const Side& other = sides[1 - own];
    sample.own = {sides[own].hit->surface_id, 0};
    sample.own_normals[0] = sides[own].hit->normal;
    sample.first_face_right = own == 0;
    if (other.step_m > rule.contact_gap_m) {
      sample.kind = EdgeKind::depth;
    } else if (other.step_m > -rule.contact_gap_m) {
      sample.kind = crease_kind(*sides[own].hit, *other.hit, rule);
    }
  }
  if (sample.kind == EdgeKind::depth) {
    const int outer = sides[0].own ? 1 : 0;
    sample.reachable = has_room(scene, camera, at, outer == 0 ? 1 : -1, sides[outer], owner, rule);
  } else if (sample.kind == EdgeKind::convex) {
    sample.reachable = has_room(scene, camera, at, 1, sides[0], owner, rule) &&
                       has_room(scene, camera, at, -1, sides[1], owner, rule);
  }
  return sample;
}

}  // namespace facet
