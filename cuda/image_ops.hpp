#pragma once

#include <cstdint>

#include "core/image_view.hpp"

namespace facet {

/// Operation of the pixels that are set in a mask.
template <class Op>
struct WhereSetOp {
  Op op;
  ImageView<const std::uint8_t> mask;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access access) const {
    if (mask(x, y)) op(x, y, access);
  }
};

template <class T>
struct SetOp {
  ImageView<T> image;
  T value;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    image(x, y) = value;
  }
};

template <class T>
struct CopyOp {
  ImageView<const T> from;
  ImageView<T> to;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    to(x, y) = from(x, y);
  }
};

}  // namespace facet
