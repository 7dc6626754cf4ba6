#pragma once

#include <optional>

#include "synth/draws.hpp"
#include "synth/scene.hpp"

namespace facet {

/// Puts `object` (resting at z = 0 about the origin) on the flat top of `below`, its middle over the inner
/// part of that top, so that it cannot tip over. False where `below` has no flat level top, too small a one,
/// or one that does not carry the whole rim of an upturned cup or bowl.
bool stand_on(const SceneObject& below, SceneObject& object, Draws& draws);

/// The centre of mass of `object` lies over the flat level top of `support`. A tower whose objects all stand
/// over every one below them cannot tip over, whatever they weigh.
bool stands_over(const SceneObject& support, const SceneObject& object);

/// A board of random size whose lower edge stands on the table and whose face leans against the upper edge of
/// an upright box that stands on the table; nothing where `box` is none.
std::optional<SceneObject> leaning_board(const SceneObject& box, double scale, Draws& draws);

}  // namespace facet
