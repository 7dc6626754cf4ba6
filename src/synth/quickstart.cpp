#include "synth/quickstart.hpp"

#include <cmath>

#include "core/random.hpp"
#include "synth/shapes.hpp"

namespace facet {
namespace {

constexpr double degree = M_PI / 180;

SceneObject placed(SceneObject object, Vec3d position, double yaw_deg, Rgb colour) {
  object.pose = translation(position) * rotation({0, 0, 1}, yaw_deg * degree);
  object.colour = colour;
  return object;
}

constexpr Rgb red{196, 62, 52}, green{88, 150, 70}, blue{62, 98, 176}, yellow{222, 184, 62},
    white{222, 220, 212}, violet{128, 82, 150}, orange{226, 128, 52}, teal{52, 148, 146};

std::vector<SceneObject> objects_of(const std::string& name) {
  if (name == "box") return {placed(make_box({0.16, 0.10, 0.12}), {0, 0, 0}, 30, red)};
  if (name == "boxes") {
    return {placed(make_box({0.18, 0.07, 0.20}), {-0.12, 0.08, 0}, 15, red),
            placed(make_box({0.12, 0.08, 0.06}), {0.05, -0.10, 0}, -35, green),
            placed(make_box({0.10, 0.10, 0.14}), {0.17, 0.08, 0}, 50, blue)};
  }
  if (name == "stacked_boxes") {
    return {placed(make_box({0.22, 0.16, 0.08}), {-0.02, 0.02, 0}, 20, yellow),
            placed(make_box({0.13, 0.09, 0.07}), {-0.03, 0.03, 0.08}, 45, red),
            placed(make_box({0.09, 0.09, 0.12}), {0.19, -0.06, 0}, -20, blue),
            placed(make_box({0.06, 0.05, 0.05}), {-0.03, 0.03, 0.15}, 10, white)};
  }
  if (name == "cylinders") {
    return {placed(make_cylinder(0.04, 0.12), {-0.12, 0.05, 0}, 0, orange),
            placed(make_cylinder(0.055, 0.07), {0.02, -0.08, 0}, 0, teal),
            placed(make_cylinder(0.03, 0.16), {0.13, 0.06, 0}, 0, violet)};
  }
  if (name == "mixed") {
    return {placed(make_box({0.17, 0.06, 0.21}), {-0.17, 0.10, 0}, 20, blue),
            placed(make_cylinder(0.045, 0.11), {0.01, 0.08, 0}, 0, orange),
            placed(make_box({0.14, 0.10, 0.06}), {0.03, -0.12, 0}, -25, green),
            placed(make_cylinder(0.035, 0.05), {0.03, -0.12, 0.06}, 0, white),
            placed(make_box({0.08, 0.08, 0.13}), {0.19, 0.03, 0}, 40, red)};
  }
  return {placed(make_box({0.20, 0.08, 0.18}), {-0.04, 0.12, 0}, 5, yellow),
          placed(make_box({0.09, 0.07, 0.10}), {-0.08, -0.02, 0}, -20, red),
          placed(make_cylinder(0.04, 0.13), {0.07, 0.01, 0}, 0, teal),
          placed(make_box({0.13, 0.06, 0.05}), {0.0, -0.15, 0}, 30, violet)};
}

}  // namespace

RigidMotion look_at(Vec3d eye, Vec3d target) {
  RigidMotion motion{.origin = eye};
  motion.ez = normalized(target - eye);
  motion.ex = normalized(cross(motion.ez, Vec3d{0, 0, 1}));
  motion.ey = cross(motion.ez, motion.ex);
  return motion;
}

std::vector<View> quickstart_views(std::uint64_t seed) {
  std::vector<View> views;
  for (const char* name : {"box", "boxes", "stacked_boxes", "cylinders", "mixed", "occluded"}) {
    const std::uint64_t index = views.size();
    View view{.name = name};
    view.scene.objects = objects_of(name);
    const double turn = (random_uniform(seed, 1, index) - 0.5) * 24 * degree;
    for (SceneObject& object : view.scene.objects) object.pose = rotation({0, 0, 1}, turn) * object.pose;
    const double tilt = (35 + 12 * random_uniform(seed, 2, index)) * degree;
    const double distance = 0.8 + 0.15 * random_uniform(seed, 3, index);
    const Vec3d target{0, 0, 0.05};
    view.T_world_camera = look_at(target + distance * Vec3d{0, -std::cos(tilt), std::sin(tilt)}, target);
    views.push_back(std::move(view));
  }
  return views;
}

View plane_and_box_view() {
  View view{.name = "plane_and_box"};
  view.scene.objects = {placed(make_box({0.18, 0.14, 0.12}), {0, 0, 0}, 35, red)};
  view.scene.has_room = false;
  view.scene.table_half_width_m = 2;
  view.scene.table_half_depth_m = 2;
  view.T_world_camera = look_at({0, -0.75, 0.65}, {0, 0, 0.04});
  return view;
}

}  // namespace facet
