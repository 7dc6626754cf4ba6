#include "synth/families.hpp"

#include <algorithm>

#include "core/error.hpp"

namespace facet {
namespace {

std::vector<SceneRecipe> all_families() {
  std::vector<SceneRecipe> all;
  all.push_back({.name = "boxes", .mix = {.box = 1}, .fewest = 2, .most = 5});
  all.push_back({.name = "stacked_boxes", .mix = {.box = 1}, .fewest = 4, .most = 7});
  all.back().stacked_share = 0.65;
  all.push_back({.name = "occluded", .mix = {.box = 3, .cylinder = 1}, .fewest = 3, .most = 5});
  all.back().spread_m = 0.14, all.back().lowest_deg = 25, all.back().highest_deg = 35;
  all.back().least_hidden = 0.25, all.back().most_hidden = 0.8;
  all.push_back({.name = "cylindrical", .mix = {.cylinder = 4, .lying_cylinder = 1, .cup = 2, .bowl = 1}});
  all.back().fewest = 3, all.back().most = 7, all.back().stacked_share = 0.15;
  all.push_back({.name = "mixed", .mix = {2, 1, 2, 0.5, 1, 0.7, 0.5}, .fewest = 4, .most = 8});
  all.back().stacked_share = 0.15, all.back().leaning_share = 0.1, all.back().touching_share = 0.15;
  all.push_back({.name = "complex", .mix = {3, 1, 2, 0.7, 1.2, 0.8, 0.6}, .fewest = 10, .most = 15});
  all.back().stacked_share = 0.3, all.back().leaning_share = 0.12, all.back().touching_share = 0.5;
  all.back().spread_m = 0.24;
  all.push_back({.name = "clutter", .mix = {3, 1, 2, 0.7, 1.2, 0.8, 0.6}, .fewest = 1, .most = 20});
  all.back().stacked_share = 0.25, all.back().touching_share = 0.3;
  all.back().spread_m = 0.28, all.back().object_scale = 0.9;
  return all;
}

/// Families with the same seed differ in every number drawn.
std::uint64_t seed_of(const std::string& name, std::uint64_t seed) {
  for (const char c : name) seed = mix_bits(seed ^ static_cast<std::uint64_t>(c));
  return seed;
}

/// The largest share of an object's pixels that others hide, from pictures of a quarter of the size.
double hidden_share(const Layout& layout, const Camera& full_camera, Size full_size) {
  const Size size{full_size.width / 4, full_size.height / 4};
  const Camera camera{full_camera.fx / 4, full_camera.fy / 4, full_camera.cx / 4, full_camera.cy / 4};
  const Rendering image = render(PosedScene(layout.view.scene, layout.view.T_world_camera), camera, size);
  double most = 0;
  for (std::size_t k = 0; k < layout.view.scene.objects.size(); ++k) {
    Scene alone{.has_table = false, .has_room = false};
    alone.objects = {layout.view.scene.objects[k]};
    const Rendering full = render(PosedScene(alone, layout.view.T_world_camera), camera, size);
    int seen = 0, all = 0;
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        seen += image.object_ids(x, y) == k + 1;
        all += full.object_ids(x, y) == 1;
      }
    }
    if (all > 0) most = std::max(most, 1 - static_cast<double>(seen) / all);
  }
  return most;
}

}  // namespace

const std::vector<SceneRecipe>& scene_families() {
  static const std::vector<SceneRecipe> families = all_families();
  return families;
}

const SceneRecipe& scene_family(const std::string& name) {
  std::string names;
  for (const SceneRecipe& family : scene_families()) {
    if (family.name == name) return family;
    names += (names.empty() ? "" : ", ") + family.name;
  }
  throw Error(ErrorKind::config, "family: there is none called '" + name + "'; expected one of " + names);
}

Layout family_layout(const SceneRecipe& recipe, std::uint64_t seed, std::uint64_t index, const Camera& camera,
                     Size size) {
  constexpr std::uint64_t tries = 500;
  const bool any = recipe.least_hidden <= 0 && recipe.most_hidden >= 1;
  for (std::uint64_t k = 0; k < tries; ++k) {
    Layout layout = random_layout(recipe, seed_of(recipe.name, seed), index * tries + k, camera, size);
    const double hidden = any ? 0 : hidden_share(layout, camera, size);
    if (hidden >= recipe.least_hidden && hidden <= recipe.most_hidden) return layout;
  }
  throw Error(ErrorKind::config, "recipe '" + recipe.name + "': no scene in 500 hides between " +
                                     std::to_string(recipe.least_hidden) + " and " +
                                     std::to_string(recipe.most_hidden) + " of an object");
}

}  // namespace facet
