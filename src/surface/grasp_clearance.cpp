#include "surface/grasp_clearance.hpp"

#include <algorithm>
#include <cmath>

namespace facet {

bool GraspClearance::is_free_outside(const PlanarContact& contact, double finger_width_m,
                                     double gap_px) const {
  const double step_m = std::max(pixel_m(), finger_width_m / 8);
  const Vec2 along = left_of(contact.inward);
  for (double out = gap_px * pixel_m(contact); out <= finger_width_m; out += step_m)
    for (double side = -finger_width_m / 2; side <= finger_width_m / 2; side += step_m)
      if (at(contact.point - out * contact.inward + side * along) != Found::nothing) return false;
  return true;
}

bool GraspClearance::is_free_between(const PlanarContact& a, const PlanarContact& b) const {
  const Vec2 across = b.point - a.point;
  const int steps = std::clamp(static_cast<int>(norm(across) / pixel_m()), 1, 1000);
  for (int i = 1; i < steps; ++i)
    if (at(a.point + (static_cast<double>(i) / steps) * across) == Found::obstacle) return false;
  return true;
}

GraspClearance::Found GraspClearance::at(Vec2 p) const {
  const Vec2 px = image_of(frame.camera(), frame.to_space(p));
  if (!(std::fabs(px.x) < 1e6 && std::fabs(px.y) < 1e6)) return Found::nothing;
  const int x = static_cast<int>(std::lround(px.x)), y = static_cast<int>(std::lround(px.y));
  if (!depth_m.size().contains(x, y)) return Found::nothing;
  if (labels(x, y) == id) return Found::surface;
  const float z = depth_m(x, y);
  if (!(z > 0)) return Found::nothing;
  const Vec3 seen = frame.camera().back_project(static_cast<float>(x), static_cast<float>(y), z);
  return frame.plane().signed_distance_m(seen) > standoff_m ? Found::obstacle : Found::nothing;
}

/// Length on the plane that a pixel covers across the contact's edge: more where the plane is seen askew.
double GraspClearance::pixel_m(const PlanarContact& contact) const {
  const auto image = [&](Vec2 p) { return image_of(frame.camera(), frame.to_space(p)); };
  const Vec2 outside = contact.point - pixel_m() * contact.inward;
  const double moved_px = norm(image(outside) - image(contact.point));
  return pixel_m() / std::max(moved_px, 0.1);
}

double GraspClearance::pixel_m() const {
  return static_cast<double>(frame.origin_m().z / frame.camera().fx);
}

}  // namespace facet
