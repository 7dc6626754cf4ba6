#pragma once

#include <array>
#include <vector>

#include "score/connected_parts.hpp"
#include "score/region_outlines.hpp"
#include "score/true_pose.hpp"
#include "truth/truth_map.hpp"

namespace facet {

/// A labelling of the truth by items that count: its surfaces, or its visible objects.
struct TruthLabels {
  Image<TruthRegion> regions{};  ///< what every pixel is for scores of these items
  Image<std::uint16_t> map{};    ///< item index + 1, 0 = none; without void pixels
  std::vector<int> area_px{};    ///< per item
  std::vector<Outline> outlines{};
  std::size_t size() const { return area_px.size(); }
};

/// A surface that counts.
struct ScoredSurface {
  int number = 0;  ///< of the annotation
  int object = 0;
  bool graspable = false, curved = false;
};

/// An object with a surface that counts.
struct ScoredObject {
  int id = 0;  ///< group id
  bool graspable = false;
  std::vector<int> surfaces{};  ///< indices of its surfaces
};

/// An edge of the annotation.
struct ScoredEdge {
  int number = 0, object = 0;
  EdgeKind kind = EdgeKind::none;
  bool graspable = false;
  bool counts = false;  ///< at least counted_edge_length_px long
  ImagePath line{};
  ImagePath samples{};  ///< at arc lengths 0, 1, 2, ... px
  /// Indices of the surfaces of its object that it bounds: at least half of its samples lie within
  /// neighbourhood_px of them.
  std::vector<int> surfaces{};
};

/// Truth of a frame with everything that the scores read by pixel, made once for all methods.
struct FrameTruth {
  Size size{};
  bool has_surfaces = false;       ///< annotated by surfaces; otherwise by object masks alone
  bool has_masks = false;          ///< object masks are known
  TruthLabels surfaces{};          ///< items: scored_surfaces; empty where they are not annotated
  ConnectedParts surface_parts{};  ///< of surfaces.map, at least counted_surface_px
  ConnectedParts support_parts{};  ///< of the support with depth, at least counted_surface_px
  /// Items: visible objects with counted_surface_px; empty without masks. Where surfaces are annotated, an
  /// object is the union of its surfaces: the rest of its mask is void.
  TruthLabels objects{};
  std::vector<int> object_values{};  ///< their mask values (group ids)
  std::vector<ScoredSurface> scored_surfaces{};
  std::vector<ScoredObject> scored_objects{};
  std::vector<ScoredEdge> edges{};
  std::vector<TruePose> poses{};

  Image<std::uint16_t> mask_object{};     ///< mask values as given, void or not; empty without masks
  Image<std::uint16_t> surface_object{};  ///< object of the surface polygon there, void or not; empty without
  Image<std::uint8_t> near_object{};      ///< 1: within region_of_interest_px of a mask or surface polygon
  std::array<Image<float>, 3> edge_distance_px{};  ///< to the lines of depth, convex, concave; up to reach

  /// 0.0075 of the image diagonal (the rule of BSDS500): 6 px at 640x480.
  double tolerance_px() const;
};

inline constexpr double region_of_interest_px = 20;
/// What lies this near to an edge is at the edge.
inline constexpr double neighbourhood_px = 3;
/// Largest tolerance of the curve of edge scores.
inline constexpr int edge_curve_px = 10;

/// Truth of an annotated frame. `object_masks` (visible objects, 0 = none) and `depth_m` (raw, 0 = missing)
/// may be empty, `poses` too. Throws Error{data} where sizes differ.
FrameTruth frame_truth(const Truth& truth, const Image<std::uint16_t>& object_masks,
                       const Image<float>& depth_m, std::vector<TruePose> poses = {});

/// Truth of a frame of which only object masks are known: it serves the scores of objects by pixel alone.
/// Void are pixels without depth off the objects, and objects of fewer than counted_surface_px pixels.
FrameTruth frame_truth(const Image<std::uint16_t>& object_masks, const Image<float>& depth_m);

}  // namespace facet
