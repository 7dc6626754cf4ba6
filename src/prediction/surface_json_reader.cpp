#include <limits>

#include "file/file_bytes.hpp"
#include "prediction/json_place.hpp"
#include "prediction/surface_json.hpp"

namespace facet {
namespace {

Vec3 read_vec3(const JsonPlace& place) {
  const auto v = place.numbers<3>();
  return {v[0], v[1], v[2]};
}

ContourPoint read_point(const JsonPlace& place, Size size) {
  const auto items = place.items();
  if (items.size() != 2) place.fail("expected the point [x, y]");
  const ContourPoint point{items[0].integer(), items[1].integer()};
  if (!size.contains(point.x, point.y)) place.fail("the point lies outside the image");
  return point;
}

Polyline read_polyline(const JsonPlace& place, Size size) {
  Polyline polyline;
  for (const JsonPlace& item : place.items()) polyline.push_back(read_point(item, size));
  return polyline;
}

Contour read_contour(const JsonPlace& place, Size size) {
  place.only({"outer", "holes"});
  Contour contour{read_polyline(place.at("outer"), size), {}};
  if (place.has("holes"))
    for (const JsonPlace& hole : place.at("holes").items())
      contour.holes.push_back(read_polyline(hole, size));
  return contour;
}

Plane read_plane(const JsonPlace& place) {
  place.only({"normal", "d_m"});
  return {read_vec3(place.at("normal")), place.at("d_m").number()};
}

SurfacePose read_pose(const JsonPlace& place) {
  place.only({"centre_m", "quaternion_wxyz", "zyx_deg", "rect_axis", "world"});
  SurfacePose pose;
  pose.centre_m = read_vec3(place.at("centre_m"));
  pose.quaternion_wxyz = place.at("quaternion_wxyz").numbers<4>();
  if (place.has("zyx_deg")) pose.zyx_deg = place.at("zyx_deg").numbers<3>();
  if (place.has("rect_axis")) pose.rect_axis = read_vec3(place.at("rect_axis"));
  return pose;
}

Grasp read_grasp_members(const JsonPlace& place) {
  const auto contacts_m = place.at("contacts_m").items(), contacts_px = place.at("contacts_px").items();
  if (contacts_m.size() != 2) place.at("contacts_m").fail("expected 2 points");
  if (contacts_px.size() != 2) place.at("contacts_px").fail("expected 2 points");
  Grasp grasp;
  for (std::size_t i = 0; i < 2; ++i) {
    grasp.contacts_m[i] = read_vec3(contacts_m[i]);
    const auto px = contacts_px[i].numbers<2>();
    grasp.contacts_px[i] = {static_cast<double>(px[0]), static_cast<double>(px[1])};
  }
  grasp.closing_axis = read_vec3(place.at("closing_axis"));
  grasp.width_m = place.at("width_m").number();
  if (place.has("score")) grasp.score = place.at("score").number();
  return grasp;
}

Grasp read_grasp(const JsonPlace& place) {
  place.only({"contacts_m", "contacts_px", "closing_axis", "width_m", "score"});
  return read_grasp_members(place);
}

FreeGrasp read_free_grasp(const JsonPlace& place) {
  place.only({"contacts_m", "contacts_px", "closing_axis", "width_m", "score", "approach_axis"});
  return {read_grasp_members(place), read_vec3(place.at("approach_axis"))};
}

/// A number of the plane's fit; null is NaN where there is a plane, 0 where there is none.
float read_fit_number(const JsonPlace& place, const Surface& surface) {
  if (!place.is_null()) return place.number();
  return surface.plane ? std::numeric_limits<float>::quiet_NaN() : 0.0f;
}

void read_fit(const JsonPlace& place, Surface& surface) {
  if (place.has("plane") && !place.at("plane").is_null()) surface.plane = read_plane(place.at("plane"));
  if (place.has("inlier_share")) surface.inlier_share = read_fit_number(place.at("inlier_share"), surface);
  if (place.has("rms_m")) surface.rms_m = read_fit_number(place.at("rms_m"), surface);
  if (place.has("curved")) surface.curved = place.at("curved").flag();
  if (place.has("pose") && !place.at("pose").is_null()) {
    surface.pose = read_pose(place.at("pose"));
  } else {
    surface.no_pose_reason = place.has("pose_reason") ? place.at("pose_reason").text() : pose_not_provided;
  }
}

Surface read_surface(const JsonPlace& place, Size size) {
  place.only({"id", "area_px", "parent", "children", "plane", "plane_reason", "inlier_share",
              "inlier_share_reason", "rms_m", "rms_m_reason", "curved", "pose", "pose_reason", "graspable",
              "grasps", "grasps_reason", "contour", "object"});
  Surface surface;
  surface.id = place.at("id").integer();
  if (place.has("area_px")) surface.area_px = place.at("area_px").integer();
  if (place.has("area_px") && surface.area_px <= 0) place.at("area_px").fail("expected a positive number");
  if (place.has("parent")) surface.parent = place.at("parent").integer();
  if (place.has("children"))
    for (const JsonPlace& child : place.at("children").items()) surface.children.push_back(child.integer());
  read_fit(place, surface);
  if (place.has("graspable")) surface.graspable = place.at("graspable").flag();
  if (place.has("grasps") && !place.at("grasps").is_null())
    for (const JsonPlace& grasp : place.at("grasps").items()) surface.grasps.push_back(read_grasp(grasp));
  if (place.has("object")) surface.object = place.at("object").integer();
  if (place.has("contour")) surface.contour = read_contour(place.at("contour"), size);
  return surface;
}

RejectedRegion read_rejected(const JsonPlace& place, Size size) {
  place.only({"seed", "area_px", "reason"});
  return {read_point(place.at("seed"), size), place.at("area_px").integer(), place.at("reason").text()};
}

FloatJson parse(const std::filesystem::path& path) {
  const auto bytes = read_file_bytes(path);
  try {
    return FloatJson::parse(bytes.begin(), bytes.end());
  } catch (const FloatJson::exception& e) {
    throw Error(ErrorKind::data, printable(path) + ": is not valid JSON: " + e.what());
  }
}

}  // namespace

void read_surfaces_json(const std::filesystem::path& path, Prediction& prediction) {
  const FloatJson json = parse(path);
  const JsonPlace top(json, printable(path));
  const Size size = prediction.labels.size();
  if (!top.is_list()) top.only({"surfaces", "rejected", "grasps", "note"});
  const JsonPlace list = top.is_list() ? top : top.at("surfaces");
  for (const JsonPlace& item : list.items()) prediction.surfaces.push_back(read_surface(item, size));
  if (top.is_list()) return;
  if (top.has("rejected"))
    for (const JsonPlace& item : top.at("rejected").items())
      prediction.rejected.push_back(read_rejected(item, size));
  if (top.has("grasps"))
    for (const JsonPlace& item : top.at("grasps").items()) prediction.grasps.push_back(read_free_grasp(item));
  if (top.has("note")) prediction.note = top.at("note").text();
}

}  // namespace facet
