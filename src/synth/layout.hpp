#pragma once

#include <string>
#include <vector>

#include "synth/quickstart.hpp"
#include "synth/random_object.hpp"

namespace facet {

/// What a random table-top scene is made of and where the camera stands.
struct SceneRecipe {
  std::string name;
  ObjectMix mix{};
  int fewest = 3, most = 5;   ///< number of objects
  double stacked_share = 0;   ///< chance that an object stands on another one
  double leaning_share = 0;   ///< chance that an object is a board that leans against a box
  double touching_share = 0;  ///< chance that an object is pushed against its neighbour
  double spread_m = 0.22;     ///< objects stand within this distance of the middle of the table
  double gap_m = 0.004;       ///< least distance of objects that do not touch
  double object_scale = 1;
  double nearest_m = 0.75, farthest_m = 0.95;  ///< distance of the camera from the middle
  double lowest_deg = 35, highest_deg = 50;    ///< its elevation
  double least_hidden = 0,
         most_hidden = 1;  ///< range of the largest share of an object that others hide, 0..1
};

/// What the cameras of all layouts look at [m, world frame].
inline constexpr Vec3d scene_middle{0, 0, 0.07};

/// A view with what each object rests on or leans against: the index of an object, or -1 for the table.
struct Layout {
  View view{};
  std::vector<int> rests_on{};
  int requested = 0;  ///< objects asked for; fewer are in the view where no more found room
};

/// An empty table with the camera of the recipe.
Layout empty_layout(const SceneRecipe& recipe, Draws& draws);
/// Adds one object that rests stably, overlaps nothing and is wholly in view; false where none of `tries`
/// did.
bool add_object(const SceneRecipe& recipe, const Camera& camera, Size size, Draws& draws, Layout& layout,
                int tries = 60);
/// Removes an object with everything that rests on it; returns how many were removed.
int remove_object(Layout& layout, int index);

/// A random scene. Throws Error{config} where not a single object can be placed. Always ends: the number of
/// tries is limited, and a shortfall shows in `requested`.
Layout random_layout(const SceneRecipe& recipe, std::uint64_t seed, std::uint64_t stream,
                     const Camera& camera, Size size);

}  // namespace facet
