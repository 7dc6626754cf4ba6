#pragma once

#include <type_traits>

#include "core/image_view.hpp"
#include "core/vec.hpp"

namespace facet {

/// Normals as three images side by side, so that those of neighbouring pixels can be worked on at once.
template <class T>
struct NormalViews {
  ImageView<T> x, y, z;

  FACET_HD Size size() const { return x.size(); }
  FACET_HD void set(int px, int py, Vec3 n) const { x(px, py) = n.x, y(px, py) = n.y, z(px, py) = n.z; }
  template <class U>
  requires(!std::is_const_v<T> && std::is_same_v<U, const T>) FACET_HD operator NormalViews<U>() const {
    return {x, y, z};
  }
};

}  // namespace facet
