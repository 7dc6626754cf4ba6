#pragma once

namespace facet {

struct ObjectParams {
  bool enabled = true;
  /// Least share of convex pixels among the creases between two faces, 0..1: two votes to one.
  float min_convex_share = 0.66f;
  /// Least share of creases along their border, 0..1; near corners a few are depth edges.
  float min_crease_share = 0.75f;
  bool hollow = true;  ///< a hollow inside belongs to the curved outside that hides part of it
  /// What leaves the image and is larger than its square is no object [mm], 0..100000: twice what a hand
  /// spans.
  float max_size_mm = 500;
};

}  // namespace facet
