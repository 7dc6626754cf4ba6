#include "synth/table2.hpp"

#include <algorithm>
#include <cstdlib>

#include "core/error.hpp"
#include "synth/hull_overlap.hpp"

namespace facet {
namespace {

SceneRecipe recipe_of(const Table2Row& row) {
  SceneRecipe recipe{.name = row.name};
  recipe.nearest_m = 0.75, recipe.farthest_m = 0.9;
  if (row.kind == "Boxes") recipe.mix = {.box = 1};
  if (row.kind == "Cylinders") recipe.mix = {.cylinder = 1};
  if (row.kind == "Mixed LC") recipe.mix = {.box = 2, .cylinder = 2};
  if (row.kind == "Mixed LC") recipe.spread_m = 0.26, recipe.object_scale = 0.9;
  if (row.kind != "Mixed HC") return recipe;
  recipe.mix = {.box = 2, .wedge = 0.5, .cylinder = 2, .cup = 0.5, .bowl = 0.4, .ball = 0.4};
  recipe.stacked_share = 0.2, recipe.touching_share = 0.5, recipe.leaning_share = 0.08;
  recipe.object_scale = 0.85;
  return recipe;
}

struct Evaluation {
  GraspCounts counts{};
  double interacting = 0;
};

int cost_of(const Evaluation& found, const Table2Row& row) {
  const int clutter = row.kind == "Mixed HC" && found.interacting < 0.5 ? 3 : 0;
  return 3 * std::abs(found.counts.objects - row.counts.objects) +
         std::abs(found.counts.surfaces - row.counts.surfaces) +
         std::abs(found.counts.edges - row.counts.edges) + clutter;
}

/// The counts are those of the row, and stay so where a reader measures lengths and areas a little
/// differently.
bool is_found(const Layout& layout, const Table2Row& row, const Camera& camera, Size size) {
  constexpr double slack = 0.03;
  const PosedScene posed(layout.view.scene, layout.view.T_world_camera);
  const Rendering exact = render(posed, camera, size);
  const SceneTruth truth = scene_truth(layout.view, posed, exact, camera);
  const double interacting = interacting_share(layout, exact);
  for (const double factor : {1 - slack, 1.0, 1 + slack}) {
    if (cost_of({grasp_counts(truth, factor), interacting}, row) != 0) return false;
  }
  return true;
}

/// The same from a picture of half the size and edges walked in steps of 1 px: near enough to guide the
/// search.
Evaluation estimate(const Layout& layout, const Camera& camera, Size size) {
  const View& view = layout.view;
  const PosedScene posed(view.scene, view.T_world_camera);
  const Camera half{camera.fx / 2, camera.fy / 2, (camera.cx - 0.5f) / 2, (camera.cy - 0.5f) / 2};
  const Rendering exact = render(posed, half, {size.width / 2, size.height / 2});
  EdgeWalk walk;
  walk.step_px = 1;
  SceneTruth truth;
  truth.edges = true_edges(view.scene, view.T_world_camera, posed, camera, size, walk);
  truth.faces = true_faces(view.scene, posed, exact, half, truth.edges);
  for (TrueFace& face : truth.faces) face.visible_px *= 4;
  return {grasp_counts(truth), interacting_share(layout, exact)};
}

/// The layout with one object (and what rests on it) exchanged; nothing where no exchange found room.
bool exchange_one(const SceneRecipe& recipe, const Camera& camera, Size size, Draws& draws, Layout& layout) {
  const int gone = remove_object(layout, draws.below(static_cast<int>(layout.rests_on.size())));
  for (int k = 0; k < gone; ++k) {
    if (!add_object(recipe, camera, size, draws, layout)) return false;
  }
  return true;
}

}  // namespace

const std::vector<Table2Row>& table2_rows() {
  static const std::vector<Table2Row> rows{
      {"boxes_1", "Boxes", {3, 6, 17}},         {"boxes_2", "Boxes", {3, 8, 20}},
      {"cylinders_1", "Cylinders", {3, 6, 12}}, {"cylinders_2", "Cylinders", {5, 10, 20}},
      {"mixed_lc_1", "Mixed LC", {6, 13, 28}},  {"mixed_lc_2", "Mixed LC", {7, 13, 28}},
      {"mixed_hc_1", "Mixed HC", {11, 24, 55}}, {"mixed_hc_2", "Mixed HC", {14, 22, 49}}};
  return rows;
}

double interacting_share(const Layout& layout, const Rendering& exact) {
  constexpr double touching_m = 0.002;
  const auto& objects = layout.view.scene.objects;
  std::vector<bool> interacts(objects.size());
  for (std::size_t a = 0; a < objects.size(); ++a) {
    if (layout.rests_on[a] >= 0)
      interacts[a] = interacts[static_cast<std::size_t>(layout.rests_on[a])] = true;
    for (std::size_t b = a + 1; b < objects.size(); ++b) {
      if (objects_overlap(objects[a], objects[b], touching_m)) interacts[a] = interacts[b] = true;
    }
  }
  // Neighbouring pixels of two objects with a jump in depth: the nearer one hides the other.
  for (int y = 0; y < exact.depth_m.height(); ++y) {
    for (int x = 1; x < exact.depth_m.width(); ++x) {
      const int a = exact.object_ids(x - 1, y), b = exact.object_ids(x, y);
      if (a == 0 || b == 0 || a == b) continue;
      const float step = exact.depth_m(x, y) - exact.depth_m(x - 1, y);
      if (std::abs(step) > 0.01f) interacts[static_cast<std::size_t>(step > 0 ? a - 1 : b - 1)] = true;
    }
  }
  return static_cast<double>(std::count(interacts.begin(), interacts.end(), true)) /
         static_cast<double>(std::max<std::size_t>(1, objects.size()));
}

Layout table2_layout(const Table2Row& row, std::uint64_t seed, const Camera& camera, Size size,
                     int evaluations) {
  constexpr int patience = 150;  // evaluations without a better layout before a fresh start
  SceneRecipe recipe = recipe_of(row);
  recipe.fewest = recipe.most = row.counts.objects;
  for (std::uint64_t start = 0; evaluations > 0; ++start) {
    Layout layout = random_layout(recipe, mix_bits(seed) ^ mix_bits(row.counts.edges), start, camera, size);
    --evaluations;
    if (static_cast<int>(layout.rests_on.size()) != row.counts.objects) continue;
    Draws draws(seed, mix_bits(start) ^ static_cast<std::uint64_t>(row.counts.surfaces));
    int cost = cost_of(estimate(layout, camera, size), row);
    for (int idle = 0; idle < patience && evaluations > 0; ++idle, --evaluations) {
      if (cost == 0 && is_found(layout, row, camera, size)) return layout;
      Layout changed = layout;
      if (!exchange_one(recipe, camera, size, draws, changed)) continue;
      const int changed_cost = cost_of(estimate(changed, camera, size), row);
      if (changed_cost > cost) continue;
      if (changed_cost < cost) idle = 0;
      cost = changed_cost;
      layout = std::move(changed);
    }
  }
  throw Error(ErrorKind::config, "table2: no layout with the counts of '" + row.name + "' was found");
}

}  // namespace facet
