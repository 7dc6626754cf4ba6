#include "synth/layout.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.hpp"
#include "synth/hull_overlap.hpp"
#include "synth/resting.hpp"

namespace facet {
namespace {

constexpr double degree = M_PI / 180;
constexpr double highest_stack_m = 0.32, contact_m = 0.0005;

bool in_view(const SceneObject& object, const Layout& layout, const Camera& camera, Size size) {
  // Kinect v1 frames lack 53 rows on top and 72 columns on the right.
  constexpr double border_px = 12, top_px = 60, right_px = 80;
  constexpr double nearest_m = 0.5;  // Kinect v1 and Azure Kinect measure nothing nearer
  for (const Hull& hull : posed_hulls(object)) {
    for (const Vec3d& corner : hull.points) {
      const Vec3d p = layout.view.T_world_camera.unapply(corner);
      const double grown = hull.radius_m * camera.fx / p.z;
      const double x = camera.fx * p.x / p.z + camera.cx, y = camera.fy * p.y / p.z + camera.cy;
      if (p.z - hull.radius_m < nearest_m || x < grown + border_px || y < grown + top_px ||
          x > size.width - grown - right_px || y > size.height - grown - border_px)
        return false;
    }
  }
  return true;
}

bool on_table(const SceneObject& object, const Scene& scene) {
  for (const Hull& hull : posed_hulls(object)) {
    for (const Vec3d& p : hull.points) {
      if (std::abs(p.x) > scene.table_half_width_m || std::abs(p.y) > scene.table_half_depth_m) return false;
    }
  }
  return true;
}

/// Touches nothing but what it rests on.
bool is_free(const SceneObject& object, const Layout& layout, int rests_on, double gap_m) {
  for (std::size_t k = 0; k < layout.view.scene.objects.size(); ++k) {
    if (static_cast<int>(k) == rests_on) continue;
    if (objects_overlap(object, layout.view.scene.objects[k], gap_m)) return false;
  }
  return true;
}

/// Pushes a free object on the table towards another one until it touches something.
void push_together(SceneObject& object, const Layout& layout, Draws& draws) {
  const auto& others = layout.view.scene.objects;
  const SceneObject& other = others[static_cast<std::size_t>(draws.below(static_cast<int>(others.size())))];
  Vec3d way = other.pose.origin - object.pose.origin;
  way.z = 0;
  double free = 0, blocked = 1;
  for (int k = 0; k < 12; ++k) {
    const double middle = 0.5 * (free + blocked);
    SceneObject moved = object;
    moved.pose.origin = object.pose.origin + middle * way;
    (is_free(moved, layout, -1, contact_m) ? free : blocked) = middle;
  }
  object.pose.origin = object.pose.origin + free * way;
}

struct Placing {
  SceneObject object;
  int rests_on = -1;
};

std::optional<Placing> drawn_placing(const SceneRecipe& recipe, const Layout& layout, Draws& draws) {
  const auto& objects = layout.view.scene.objects;
  const int count = static_cast<int>(objects.size());
  const double kind = draws.uniform(0, 1);
  if (count > 0 && kind < recipe.leaning_share) {
    const int against = draws.below(count);
    auto board = leaning_board(objects[static_cast<std::size_t>(against)], recipe.object_scale, draws);
    if (!board) return {};
    return Placing{std::move(*board), against};
  }
  SceneObject object = random_object(recipe.mix, recipe.object_scale, draws);
  if (count > 0 && kind < recipe.leaning_share + recipe.stacked_share) {
    const int below = draws.below(count);
    if (object.shape == "ball" || !stand_on(objects[static_cast<std::size_t>(below)], object, draws))
      return {};
    if (object.pose.origin.z > highest_stack_m) return {};
    for (int k = layout.rests_on[static_cast<std::size_t>(below)]; k >= 0;
         k = layout.rests_on[static_cast<std::size_t>(k)]) {
      if (!stands_over(objects[static_cast<std::size_t>(k)], object)) return {};
    }
    return Placing{std::move(object), below};
  }
  const double angle = draws.uniform(0, 2 * M_PI), radius = recipe.spread_m * std::sqrt(draws.uniform(0, 1));
  const Vec3d place{radius * std::cos(angle), radius * std::sin(angle), 0};
  object.pose = translation(place) * object.pose;
  const bool pushed = count > 0 && draws.chance(recipe.touching_share);
  if (pushed && is_free(object, layout, -1, recipe.gap_m)) push_together(object, layout, draws);
  return Placing{std::move(object), -1};
}

}  // namespace

Layout empty_layout(const SceneRecipe& recipe, Draws& draws) {
  Layout layout;
  layout.view.name = recipe.name;
  const double elevation = draws.uniform(recipe.lowest_deg, recipe.highest_deg) * degree;
  const double distance = draws.uniform(recipe.nearest_m, recipe.farthest_m);
  layout.view.T_world_camera =
      look_at(scene_middle + distance * Vec3d{0, -std::cos(elevation), std::sin(elevation)}, scene_middle);
  return layout;
}

bool add_object(const SceneRecipe& recipe, const Camera& camera, Size size, Draws& draws, Layout& layout,
                int tries) {
  for (int k = 0; k < tries; ++k) {
    auto placing = drawn_placing(recipe, layout, draws);
    if (!placing) continue;
    const double gap = recipe.touching_share > 0 ? contact_m / 2 : recipe.gap_m;
    SceneObject& object = placing->object;
    if (!on_table(object, layout.view.scene) || !in_view(object, layout, camera, size)) continue;
    if (!is_free(object, layout, placing->rests_on, gap)) continue;
    object.colour = unlike_colour(layout.view.scene.objects, object.colour);
    layout.view.scene.objects.push_back(std::move(object));
    layout.rests_on.push_back(placing->rests_on);
    return true;
  }
  return false;
}

int remove_object(Layout& layout, int index) {
  std::vector<bool> gone(layout.rests_on.size());
  gone[static_cast<std::size_t>(index)] = true;
  // An object rests on one that was added earlier, so a single pass finds all that fall with it.
  for (std::size_t k = 0; k < gone.size(); ++k) {
    if (layout.rests_on[k] >= 0 && gone[static_cast<std::size_t>(layout.rests_on[k])]) gone[k] = true;
  }
  std::vector<int> new_index(gone.size(), -1), rests_on;
  std::vector<SceneObject> objects;
  for (std::size_t k = 0; k < gone.size(); ++k) {
    if (gone[k]) continue;
    new_index[k] = static_cast<int>(objects.size());
    objects.push_back(layout.view.scene.objects[k]);
    rests_on.push_back(layout.rests_on[k] < 0 ? -1 : new_index[static_cast<std::size_t>(layout.rests_on[k])]);
  }
  const int removed = static_cast<int>(gone.size() - objects.size());
  layout.view.scene.objects = std::move(objects);
  layout.rests_on = std::move(rests_on);
  return removed;
}

Layout random_layout(const SceneRecipe& recipe, std::uint64_t seed, std::uint64_t stream,
                     const Camera& camera, Size size) {
  if (recipe.fewest < 1 || recipe.most < recipe.fewest) {
    throw Error(ErrorKind::config, "objects: the range " + std::to_string(recipe.fewest) + " to " +
                                       std::to_string(recipe.most) + " is empty or below 1");
  }
  Draws draws(seed, stream);
  Layout layout = empty_layout(recipe, draws);
  layout.requested = recipe.fewest + draws.below(recipe.most - recipe.fewest + 1);
  for (int k = 0; k < layout.requested; ++k) {
    if (!add_object(recipe, camera, size, draws, layout)) break;
  }
  if (layout.view.scene.objects.empty()) {
    throw Error(ErrorKind::config,
                "recipe '" + recipe.name +
                    "': object_scale or distance_m: no object of this size can be placed on the "
                    "table, in view of the camera and 0.5 m away from it");
  }
  return layout;
}

}  // namespace facet
