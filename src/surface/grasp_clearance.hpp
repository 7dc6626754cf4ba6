#pragma once

#include "surface/grasp_wrench.hpp"
#include "surface/plane_frame.hpp"

namespace facet {

/// Tells where fingers that reach down to a plane, from the side of the camera, would hit something. Pixels
/// outside the image and without depth are taken for free.
struct GraspClearance {
  ImageView<const float> depth_m;
  ImageView<const std::uint16_t> labels;
  const PlaneFrame& frame;
  int id = 0;            ///< label of the surface to be grasped
  float standoff_m = 0;  ///< what stands out of the plane by more is an obstacle

  /// Whether a square finger of that width fits outside the contact: no obstacle and no part of the surface
  /// itself on its footprint, from `gap_px` outside the contact on.
  bool is_free_outside(const PlanarContact& contact, double finger_width_m, double gap_px) const;
  /// Whether nothing that is not the surface stands out of the plane on the line between the contacts.
  bool is_free_between(const PlanarContact& a, const PlanarContact& b) const;

 private:
  enum class Found { nothing, surface, obstacle };
  Found at(Vec2 p) const;
  double pixel_m(const PlanarContact& contact) const;
  double pixel_m() const;  ///< where the plane faces the camera
};

}  // namespace facet
