#include "synth/special_scenes.hpp"

#include "synth/shapes.hpp"

namespace facet {
namespace {

constexpr double degree = M_PI / 180;
constexpr Rgb colours[] = {{196, 62, 52}, {88, 150, 70}, {62, 98, 176}, {222, 184, 62}};

Layout layout_at(const char* name, double distance_m, Draws& draws) {
  SceneRecipe recipe{.name = name};
  recipe.nearest_m = recipe.farthest_m = distance_m;
  return empty_layout(recipe, draws);
}

void place(Layout& layout, SceneObject object, double x, double y, double yaw_rad) {
  object.pose = translation({x, y, 0}) * rotation({0, 0, 1}, yaw_rad);
  object.colour = colours[layout.rests_on.size() % std::size(colours)];
  layout.view.scene.objects.push_back(std::move(object));
  layout.rests_on.push_back(-1);
  ++layout.requested;
}

}  // namespace

Layout crease_layout(double crease_deg, double distance_m, std::uint64_t seed, std::uint64_t index) {
  Draws draws(seed, index);
  Layout layout = layout_at("crease", distance_m, draws);
  for (int k = 0; k < 3; ++k) {
    const double yaw = (60 * k + draws.uniform(0, 60)) * degree;
    place(layout, make_ridge({0.12, 0.11, 0.03}, crease_deg * degree), 0.17 * (k - 1),
          draws.uniform(-0.06, 0.06), yaw);
  }
  return layout;
}

Layout gap_layout(double gap_mm, double distance_m, std::uint64_t seed, std::uint64_t index) {
  Draws draws(seed, index);
  Layout layout = layout_at("gap", distance_m, draws);
  const double shift = 0.04 + 0.0005 * gap_mm, turn = draws.uniform(-10, 10) * degree;
  for (const double side : {-1.0, 1.0}) {
    place(layout, make_box({0.08, 0.1, 0.06}), -0.12 + side * shift * std::cos(turn),
          side * shift * std::sin(turn), turn);
  }
  for (const double side : {-1.0, 1.0}) {
    place(layout, make_box({0.1, 0.08, 0.06}), 0.12 - side * shift * std::sin(turn),
          side * shift * std::cos(turn), turn);
  }
  return layout;
}

Layout strip_layout(double distance_m, std::uint64_t seed, std::uint64_t index) {
  Draws draws(seed, index);
  Layout layout = layout_at("strips", distance_m, draws);
  double x = -0.21;
  for (const double width_mm : {3.0, 5.0, 8.0, 12.0}) {
    const double yaw = draws.uniform(-40, 40) * degree;
    place(layout, make_box({0.001 * width_mm, 0.12, 0.02}), x, draws.uniform(-0.08, 0.08), yaw);
    x += 0.14;
  }
  return layout;
}

}  // namespace facet
