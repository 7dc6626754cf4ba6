#include "synth/random_object.hpp"

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "synth/shapes.hpp"

namespace facet {
namespace {

constexpr std::array<Rgb, 20> colours{Rgb{196, 62, 52}, {88, 150, 70},   {62, 98, 176},   {222, 184, 62},
                                      {222, 220, 212},  {128, 82, 150},  {226, 128, 52},  {52, 148, 146},
                                      {150, 100, 70},   {210, 130, 160}, {110, 190, 215}, {170, 205, 100},
                                      {240, 170, 150},  {100, 100, 110}, {120, 40, 60},   {40, 90, 60},
                                      {185, 165, 220},  {250, 225, 150}, {60, 60, 120},   {120, 120, 40}};

SceneObject drawn_box(double s, Draws& draws) {
  return make_box(
      {s * draws.uniform(0.06, 0.20), s * draws.uniform(0.05, 0.14), s * draws.uniform(0.05, 0.18)});
}

SceneObject drawn_wedge(double s, Draws& draws) {
  return make_wedge(
      {s * draws.uniform(0.07, 0.16), s * draws.uniform(0.07, 0.12), s * draws.uniform(0.05, 0.10)});
}

SceneObject drawn_cylinder(double s, bool lies, Draws& draws) {
  const double radius = s * draws.uniform(0.025, 0.05), height = s * draws.uniform(0.06, 0.17);
  SceneObject object = make_cylinder(radius, height);
  if (lies) object.pose = lying(radius, height);
  return object;
}

SceneObject drawn_cup(double s, Draws& draws) {
  const double base = s * draws.uniform(0.026, 0.036), height = s * draws.uniform(0.08, 0.11);
  SceneObject object = make_cup(base, base * draws.uniform(1.1, 1.35), height, draws.chance(0.7));
  if (draws.chance(0.3)) object.pose = upside_down(height);
  return object;
}

SceneObject drawn_bowl(double s, Draws& draws) {
  const double base = s * draws.uniform(0.026, 0.036), rim = s * draws.uniform(0.06, 0.08);
  const double height = draws.uniform(0.6, 0.95) * std::sqrt(rim * rim - base * base);
  SceneObject object = make_bowl(base, rim, height);
  if (draws.chance(0.5)) object.pose = upside_down(height);
  return object;
}

}  // namespace

SceneObject random_object(const ObjectMix& mix, double scale, Draws& draws) {
  const std::array<double, 7> weights{mix.box, mix.wedge, mix.cylinder, mix.lying_cylinder,
                                      mix.cup, mix.bowl,  mix.ball};
  double total = 0;
  for (const double w : weights) total += w;
  if (!(total > 0)) throw Error(ErrorKind::config, "mix: every kind of object has the weight 0");
  double pick = draws.uniform(0, total);
  std::size_t kind = 0;
  while (kind + 1 < weights.size() && (pick >= weights[kind] || weights[kind] == 0)) pick -= weights[kind++];
  SceneObject object;
  switch (kind) {
    case 0:
      object = drawn_box(scale, draws);
      break;
    case 1:
      object = drawn_wedge(scale, draws);
      break;
    case 2:
      object = drawn_cylinder(scale, false, draws);
      break;
    case 3:
      object = drawn_cylinder(scale, true, draws);
      break;
    case 4:
      object = drawn_cup(scale, draws);
      break;
    case 5:
      object = drawn_bowl(scale, draws);
      break;
    default:
      object = make_ball(scale * draws.uniform(0.03, 0.055));
      break;
  }
  object.pose = rotation({0, 0, 1}, draws.uniform(0, 2 * M_PI)) * object.pose;
  object.colour = drawn_colour(draws);
  return object;
}

Rgb drawn_colour(Draws& draws) {
  return colours[static_cast<std::size_t>(draws.below(static_cast<int>(colours.size())))];
}

Rgb unlike_colour(const std::vector<SceneObject>& others, Rgb drawn) {
  const auto is_free = [&](Rgb colour) {
    return std::none_of(others.begin(), others.end(),
                        [&](const SceneObject& other) { return other.colour == colour; });
  };
  if (is_free(drawn)) return drawn;
  const auto found = std::find_if(colours.begin(), colours.end(), is_free);
  return found == colours.end() ? drawn : *found;
}

}  // namespace facet
