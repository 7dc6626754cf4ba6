#pragma once

#include "surface/vec2.hpp"

namespace facet {

/// Where a finger touches a planar body, and the unit normal into the body. Any unit of length.
struct PlanarContact {
  Vec2 point;
  Vec2 inward;
};

/// Whether two hard contacts with Coulomb friction can balance every force in the plane and every torque
/// about its normal (3 degrees of freedom): the four edges of their friction cones, as wrenches, positively
/// span the space of planar wrenches. True exactly where the line that joins the contacts lies strictly
/// inside both cones (Nguyen, "Constructing force-closure grasps", 1988), whether the fingers press towards
/// each other or, from inside a hole, away from each other. False for contacts at one point or without
/// friction.
bool spans_planar_wrenches(const PlanarContact& a, const PlanarContact& b, double friction);

}  // namespace facet
