#pragma once

#include "core/image.hpp"
#include "core/normal_views.hpp"

namespace facet {

/// Normals as the stages keep them, an image for each coordinate, made of an image of vectors and turned back
/// into one.
struct NormalPlanes {
  Image<float> x, y, z;

  explicit NormalPlanes(const Image<Vec3>& normal) : x(normal.size()), y(normal.size()), z(normal.size()) {
    for (int py = 0; py < normal.height(); ++py)
      for (int px = 0; px < normal.width(); ++px) views().set(px, py, normal(px, py));
  }
  NormalViews<float> views() { return {x.view(), y.view(), z.view()}; }
  Image<Vec3> vectors() const {
    Image<Vec3> normal(x.size());
    for (int py = 0; py < normal.height(); ++py)
      for (int px = 0; px < normal.width(); ++px) normal(px, py) = {x(px, py), y(px, py), z(px, py)};
    return normal;
  }
};

}  // namespace facet
