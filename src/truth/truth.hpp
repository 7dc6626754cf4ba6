#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/image_point.hpp"
#include "core/image_view.hpp"
#include "surface/surface.hpp"

namespace facet {

/// A closed polygon of an annotation. `order` is its place in the file: where polygons of surfaces overlap, a
/// pixel belongs to the first listed.
struct TruthPolygon {
  ImagePath path;
  int order = 0;
};

/// One face of an object: the polygons of its visible parts.
struct TruthSurface {
  int number = 0;  ///< N of `surface/N`
  int object = 0;  ///< group id, >= 1
  bool graspable = false;
  bool curved = false;
  std::vector<TruthPolygon> parts{};
  std::string description{};
};

/// One visible piece of a physical edge. The line is open.
struct TruthEdge {
  int number = 0;  ///< N of `edge/N`
  int object = 0;  ///< of the object whose geometry makes it; the nearer one at an occlusion
  EdgeKind kind = EdgeKind::none;
  bool graspable = false;
  ImagePath line{};
  std::string description{};
};

/// What an annotation says of a frame. Pixel centres lie at integer coordinates.
struct Truth {
  Size size;
  std::vector<TruthSurface> surfaces{};  ///< in the order of their first polygons
  std::vector<TruthEdge> edges{};
  std::vector<TruthPolygon> support{};  ///< the table top; minus all surfaces it is support
  std::vector<TruthPolygon> ignore{};   ///< void
};

/// Length of an open line [px].
double length_px(const ImagePath& line);

/// Void rules of the scores: surfaces with fewer pixels and shorter edges are not counted.
inline constexpr int counted_surface_px = 100;
inline constexpr double counted_edge_length_px = 12;

}  // namespace facet
