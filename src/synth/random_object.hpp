#pragma once

#include "synth/draws.hpp"
#include "synth/scene.hpp"

namespace facet {

/// How often each kind of object is drawn, in any unit.
struct ObjectMix {
  double box = 0, wedge = 0, cylinder = 0, lying_cylinder = 0, cup = 0, bowl = 0, ball = 0;
};

/// A body of random kind, size (5 to 20 cm times `scale`), colour and resting face. Its pose turns it about
/// the vertical and puts its lowest point at z = 0.
SceneObject random_object(const ObjectMix& mix, double scale, Draws& draws);

/// One of twenty colours.
Rgb drawn_colour(Draws& draws);
/// `drawn`, or, where one of the others has it, a colour that none of them has, as long as there is one.
Rgb unlike_colour(const std::vector<SceneObject>& others, Rgb drawn);

}  // namespace facet
