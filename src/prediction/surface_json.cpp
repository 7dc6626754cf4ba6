#include "prediction/surface_json.hpp"

#include <cmath>

#include "file/file_bytes.hpp"
#include "prediction/json_place.hpp"

namespace facet {
namespace {

constexpr const char* not_finite = "not finite";
constexpr const char* no_plane = "no plane was fitted";

FloatJson to_json(Vec3 v) {
  return {v.x, v.y, v.z};
}
FloatJson to_json(ContourPoint p) {
  return {p.x, p.y};
}

FloatJson to_json(const Polyline& polyline) {
  FloatJson points = FloatJson::array();
  for (const ContourPoint& point : polyline) points.push_back(to_json(point));
  return points;
}

bool is_finite(Vec3 v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool is_finite(const SurfacePose& pose) {
  bool finite = is_finite(pose.centre_m) && is_finite(pose.rect_axis);
  for (const float value : pose.quaternion_wxyz) finite = finite && std::isfinite(value);
  for (const float value : pose.zyx_deg) finite = finite && std::isfinite(value);
  return finite;
}

void put_null(FloatJson& object, const std::string& name, const std::string& reason) {
  object[name] = nullptr;
  object[name + "_reason"] = escaped_utf8(reason);
}

/// A number that tells how well the plane fits.
void put_fit_number(FloatJson& object, const std::string& name, float value, const Surface& surface) {
  if (!surface.plane) return put_null(object, name, no_plane);
  if (!std::isfinite(value)) return put_null(object, name, not_finite);
  object[name] = value;
}

void put_plane(FloatJson& object, const Surface& surface) {
  if (!surface.plane) return put_null(object, "plane", no_plane);
  const Plane& plane = *surface.plane;
  if (!is_finite(plane.normal) || !std::isfinite(plane.d_m)) return put_null(object, "plane", not_finite);
  object["plane"] = {{"normal", to_json(plane.normal)}, {"d_m", plane.d_m}};
}

void put_pose(FloatJson& object, const Surface& surface) {
  if (!surface.pose) return put_null(object, "pose", surface.no_pose_reason);
  const SurfacePose& pose = *surface.pose;
  if (!is_finite(pose)) return put_null(object, "pose", not_finite);
  object["pose"] = {{"centre_m", to_json(pose.centre_m)},
                    {"quaternion_wxyz", pose.quaternion_wxyz},
                    {"zyx_deg", pose.zyx_deg},
                    {"rect_axis", to_json(pose.rect_axis)}};
}

bool is_finite(const Grasp& grasp) {
  bool finite = is_finite(grasp.closing_axis) && std::isfinite(grasp.width_m) && std::isfinite(grasp.score);
  for (const Vec3& contact : grasp.contacts_m) finite = finite && is_finite(contact);
  for (const ImagePoint& p : grasp.contacts_px) finite = finite && std::isfinite(p.x) && std::isfinite(p.y);
  return finite;
}

FloatJson to_json(const Grasp& grasp) {
  FloatJson contacts_px = FloatJson::array();
  for (const ImagePoint& p : grasp.contacts_px)
    contacts_px.push_back({static_cast<float>(p.x), static_cast<float>(p.y)});
  return {{"contacts_m", {to_json(grasp.contacts_m[0]), to_json(grasp.contacts_m[1])}},
          {"contacts_px", std::move(contacts_px)},
          {"closing_axis", to_json(grasp.closing_axis)},
          {"width_m", grasp.width_m},
          {"score", grasp.score}};
}

FloatJson to_json(const FreeGrasp& free) {
  FloatJson object = to_json(free.grasp);
  object["approach_axis"] = to_json(free.approach_axis);
  return object;
}

void put_grasps(FloatJson& object, const Surface& surface) {
  FloatJson grasps = FloatJson::array();
  for (const Grasp& grasp : surface.grasps) {
    if (!is_finite(grasp)) return put_null(object, "grasps", not_finite);
    grasps.push_back(to_json(grasp));
  }
  object["grasps"] = std::move(grasps);
}

FloatJson to_json(const Contour& contour) {
  FloatJson holes = FloatJson::array();
  for (const Polyline& hole : contour.holes) holes.push_back(to_json(hole));
  return {{"outer", to_json(contour.outer)}, {"holes", std::move(holes)}};
}

FloatJson to_json(const Surface& surface) {
  FloatJson object;
  object["id"] = surface.id;
  object["area_px"] = surface.area_px;
  object["parent"] = surface.parent;
  object["children"] = surface.children;
  put_plane(object, surface);
  put_fit_number(object, "inlier_share", surface.inlier_share, surface);
  put_fit_number(object, "rms_m", surface.rms_m, surface);
  object["curved"] = surface.curved;
  put_pose(object, surface);
  object["graspable"] = surface.graspable;
  put_grasps(object, surface);
  if (surface.object != 0) object["object"] = surface.object;
  object["contour"] = to_json(surface.contour);
  return object;
}

FloatJson to_json(const RejectedRegion& region) {
  return {
      {"seed", to_json(region.seed)}, {"area_px", region.area_px}, {"reason", escaped_utf8(region.reason)}};
}

/// A list with one item per line.
template <class Items>
std::string lines(const Items& items) {
  std::string text = "[";
  for (const auto& item : items) text += (text.size() == 1 ? "\n" : ",\n") + to_json(item).dump();
  return text + (items.empty() ? "]" : "\n]");
}

std::vector<FreeGrasp> finite_only(std::vector<FreeGrasp> grasps) {
  std::erase_if(grasps,
                [](const FreeGrasp& g) { return !is_finite(g.grasp) || !is_finite(g.approach_axis); });
  return grasps;
}

}  // namespace

std::string surfaces_to_json(const Prediction& prediction) {
  const std::string grasps =
      prediction.grasps.empty() ? "" : ",\n\"grasps\": " + lines(finite_only(prediction.grasps));
  return "{\"surfaces\": " + lines(prediction.surfaces) + ",\n\"rejected\": " + lines(prediction.rejected) +
         grasps + ",\n\"note\": " + FloatJson(escaped_utf8(prediction.note)).dump() + "}\n";
}

}  // namespace facet
