#pragma once

#include "synth/layout.hpp"
#include "synth/scene_truth.hpp"

namespace facet {

/// Recipes named after the groups of scenes in the Object Segmentation Database: boxes, stacked_boxes,
/// occluded, cylindrical, mixed, complex; and `clutter`, whose number of objects is set by its user.
const std::vector<SceneRecipe>& scene_families();
/// Error{config} listing the names where there is no such family.
const SceneRecipe& scene_family(const std::string& name);

/// A random scene of the family, drawn again (at most 500 times) until one object is hidden as the recipe
/// demands. Error{config} where that never happens.
Layout family_layout(const SceneRecipe& recipe, std::uint64_t seed, std::uint64_t index, const Camera& camera,
                     Size size);

}  // namespace facet
