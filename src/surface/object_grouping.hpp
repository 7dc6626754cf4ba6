#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/camera.hpp"
#include "core/disjoint_sets.hpp"
#include "core/image_view.hpp"
#include "surface/object_params.hpp"
#include "surface/pose.hpp"
#include "surface/surface.hpp"
#include "surface/surface_borders.hpp"

namespace facet {

/// What objects are made of.
struct ObjectInput {
  ImageView<const std::uint16_t> labels;
  ImageView<const std::uint8_t> edges;
  const std::vector<PointSample>& points;  ///< by surface
  Camera camera;
  int support = 0;  ///< label, 0 = none
  std::optional<Plane> support_plane;
};

/// Groups surfaces into objects: most things are convex, so that faces that meet in a convex edge belong to
/// one of them, while things that touch meet in concave edges, and depth edges part what is behind each
/// other, save the inside of a hollow thing from its outside. Keeps its memory between frames.
class ObjectGrouping {
 public:
  /// Sets `object` of every surface: the least id of its group; 0 for the support and what lies around it.
  void group(const ObjectInput& input, const ObjectParams& params, std::vector<Surface>& surfaces);

 private:
  struct Face {
    bool is_background = false;
    bool is_curved = false;     ///< one plane does not explain it
    float curvature_per_m = 0;  ///< of a patch fitted to it: positive = hollow towards the camera
    int outside_px = 0;         ///< longest border where a bulging surface hides part of it
    int outside = 0;            ///< label of that surface
    int border_px = 0;          ///< of all its borders
  };
  void describe(const ObjectInput& input, const ObjectParams& params, const std::vector<Surface>& surfaces);
  void join_convex(const ObjectParams& params);
  void join_hollow();
  Face& face(int label) { return faces_[static_cast<std::size_t>(label) - 1]; }

  SurfaceBorders borders_;
  std::vector<Face> faces_;  ///< by label
  DisjointSets objects_;     ///< of labels
};

}  // namespace facet
