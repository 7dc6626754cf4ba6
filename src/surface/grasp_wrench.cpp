#include "surface/grasp_wrench.hpp"

#include <array>

namespace facet {
namespace {

/// Force in the plane and torque about its normal, the torque in units of force.
struct Wrench {
  Vec2 force;
  double torque = 0;
};

double determinant(const Wrench& a, const Wrench& b, const Wrench& c) {
  return a.torque * cross(b.force, c.force) + b.torque * cross(c.force, a.force) +
         c.torque * cross(a.force, b.force);
}

}  // namespace

bool spans_planar_wrenches(const PlanarContact& a, const PlanarContact& b, double friction) {
  const double distance = norm(b.point - a.point);
  if (!(distance > 0) || !(friction > 0)) return false;
  const Vec2 middle = 0.5 * (a.point + b.point);
  std::array<Wrench, 4> w;
  std::size_t n = 0;
  for (const PlanarContact* contact : {&a, &b})
    for (const double side : {friction, -friction}) {
      const Vec2 force = contact->inward + side * left_of(contact->inward);
      w[n++] = {force, cross((1 / distance) * (contact->point - middle), force)};
    }
  // Four vectors span three dimensions positively if and only if every weight of the one combination of them
  // that is zero has the same sign (none is zero); by Cramer's rule the weights are these determinants.
  const std::array<double, 4> weight{determinant(w[1], w[2], w[3]), -determinant(w[0], w[2], w[3]),
                                     determinant(w[0], w[1], w[3]), -determinant(w[0], w[1], w[2])};
  constexpr double rounding = 1e-9;
  bool all_positive = true, all_negative = true;
  for (const double v : weight) {
    all_positive = all_positive && v > rounding;
    all_negative = all_negative && v < -rounding;
  }
  return all_positive || all_negative;
}

}  // namespace facet
