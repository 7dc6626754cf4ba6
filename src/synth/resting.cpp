#include "synth/resting.hpp"

#include <algorithm>
#include <cmath>

#include "synth/hull_overlap.hpp"
#include "synth/intersect.hpp"
#include "synth/random_object.hpp"
#include "synth/shapes.hpp"

namespace facet {
namespace {

double highest_point(const SceneObject& object) {
  double z = -1e9;
  for (const Hull& hull : posed_hulls(object)) {
    for (const Vec3d& p : hull.points) z = std::max(z, p.z + hull.radius_m);
  }
  return z;
}

/// The flat face, level and facing up, that is the highest part of the object: its patch in the world frame.
std::optional<Patch> level_top(const SceneObject& object) {
  const double top = highest_point(object);
  for (const Patch& patch : object.patches) {
    Patch posed = patch;
    posed.frame = object.pose * patch.frame;
    const bool flat = patch.shape == PatchShape::polygon || patch.shape == PatchShape::disc;
    if (flat && posed.frame.ez.z > 1 - 1e-9 && std::abs(posed.frame.origin.z - top) < 1e-6) return posed;
  }
  return {};
}

/// A random point of the patch's inner part (0: middle, 1: border).
Vec3d inner_point(const Patch& patch, double reach, Draws& draws) {
  if (patch.shape == PatchShape::disc) {
    const double angle = draws.uniform(0, 2 * M_PI), radius = reach * patch.radius_m * draws.uniform(0, 1);
    return patch.frame.apply({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  Vec3d middle{};
  for (int k = 0; k < patch.corner_count; ++k)
    middle = middle + (1.0 / patch.corner_count) * patch.corners[k];
  const Vec3d corner = patch.corners[static_cast<std::size_t>(draws.below(patch.corner_count))];
  return patch.frame.apply(middle + reach * draws.uniform(0, 1) * (corner - middle));
}

double radius_of(const Patch& top) {
  double radius = top.radius_m;
  for (int k = 0; k < top.corner_count; ++k)
    radius = std::max(radius, 0.5 * norm(top.corners[k] - top.corners[0]));
  return radius;
}

/// Largest distance from the z axis of the points that the object stands on.
double base_radius(const SceneObject& object) {
  double radius = 0;
  for (const Hull& hull : posed_hulls(object)) {
    for (const Vec3d& p : hull.points) {
      if (p.z < 1e-6) radius = std::max(radius, std::hypot(p.x, p.y));
    }
  }
  return radius;
}

/// The point of the world lies above or below the level patch.
bool is_over(const Patch& top, Vec3d point) {
  const Vec3d p = top.frame.unapply(point);
  return within_trim(top, {p.x, p.y, 0});
}

/// Middle of its body: of the corners of a prism, on the axis of a round one.
Vec3d centre_of(const SceneObject& object) {
  const Hull body = posed_hulls(object).front();
  Vec3d sum{};
  for (const Vec3d& p : body.points) sum = sum + p;
  return (1.0 / static_cast<double>(body.points.size())) * sum;
}

/// A cup or a bowl that stands on its rim: open below.
bool stands_on_rim(const SceneObject& object) {
  return (object.shape == "cup" || object.shape == "bowl") && object.pose.ez.z < 0;
}

}  // namespace

bool stands_over(const SceneObject& support, const SceneObject& object) {
  const auto top = level_top(support);
  return top && is_over(*top, centre_of(object));
}

bool stand_on(const SceneObject& below, SceneObject& object, Draws& draws) {
  const auto top = level_top(below);
  constexpr double largest_overhang = 1.1;
  if (!top || base_radius(object) > largest_overhang * radius_of(*top)) return false;
  const double rim = stands_on_rim(object) ? base_radius(object) : 0;
  const Vec3d place = inner_point(*top, 0.45, draws);
  object.pose = translation(place) * object.pose;
  constexpr int rim_points = 16;
  for (int k = 0; k < rim_points && rim > 0; ++k) {
    const double angle = 2 * M_PI * k / rim_points;
    if (!is_over(*top, place + rim * Vec3d{std::cos(angle), std::sin(angle), 0})) return false;
  }
  return stands_over(below, object);
}

std::optional<SceneObject> leaning_board(const SceneObject& box, double scale, Draws& draws) {
  const auto top = level_top(box);
  const bool on_table = std::abs(box.pose.origin.z) < 1e-9;
  if (box.shape != "box" || !top || !on_table) return {};
  const int side = draws.below(4);
  const Vec3d a = top->frame.apply(top->corners[static_cast<std::size_t>(side)]);
  const Vec3d b = top->frame.apply(top->corners[static_cast<std::size_t>((side + 1) % 4)]);
  const double height = a.z, width = norm(b - a);
  const Vec3d along = normalized(b - a), outward = cross(along, {0, 0, 1}), up{0, 0, 1};
  const double foot = height * draws.uniform(0.3, 0.6), reach = std::hypot(foot, height);
  const double length = reach * draws.uniform(1.05, 1.35), thickness = scale * draws.uniform(0.012, 0.03);
  const Vec3d rising =
      (1 / reach) * (height * up - foot * outward);                  // along the board, from its foot upwards
  const Vec3d outer = (1 / reach) * (height * outward + foot * up);  // from the inner to the outer face
  SceneObject board = make_box({width * draws.uniform(0.4, 0.85), thickness, length});
  const Vec3d foot_point = 0.5 * (a + b) - height * up + foot * outward;
  board.pose = {cross(outer, rising), outer, rising, foot_point + (0.5 * thickness) * outer};
  board.colour = drawn_colour(draws);
  return board;
}

}  // namespace facet
