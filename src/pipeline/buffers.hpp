#pragma once

#include <cstdint>

#include "core/image.hpp"

namespace facet {

/// The images that the stages hand to each other, on the executor's side; allocated once per frame size.
template <class Executor>
struct Buffers {
  template <class T>
  using Image = typename Executor::template Image<T>;

  Image<float> depth, averaged, scratch_a, scratch_b, scratch_c;
  Image<float> gx, gy, strength;
  Image<std::uint8_t> filled, direction, ridge, depth_edge, crease_edge, edge, distance;
  Image<std::uint8_t> mask_a, mask_b, mask_c, code;
  Image<std::int32_t> inverse_depth, root;
  Image<std::uint16_t> label, owner;

  void resize(Size size) {
    for (Image<float>* i : {&depth, &averaged, &scratch_a, &scratch_b, &scratch_c, &gx, &gy, &strength})
      i->resize(size);
    for (Image<std::uint8_t>* i : {&filled, &direction, &ridge, &depth_edge, &crease_edge, &edge, &distance,
                                   &mask_a, &mask_b, &mask_c, &code})
      i->resize(size);
    inverse_depth.resize(size);
    root.resize(size);
    label.resize(size);
    owner.resize(size);
  }
};

}  // namespace facet
