#pragma once

#include <cstdint>
#include <vector>

#include "core/image_view.hpp"

namespace facet {

/// Working copy of a sparse 0/1 mask that knows the state of every pixel's eight neighbours (bit i =
/// neighbour8(i)) and keeps it up to date while pixels are deleted, so that rules on neighbourhoods cost one
/// table look-up. Padded by one pixel on each side: no border tests. Pixels are named by their index in the
/// padded image.
class SparseMask {
 public:
  /// Copies the mask and lists its pixels.
  void assign(ImageView<const std::uint8_t> mask, std::vector<int>& pixels);
  bool has(int pixel) const { return set_[static_cast<std::size_t>(pixel)] != 0; }
  unsigned code(int pixel) const { return code_[static_cast<std::size_t>(pixel)]; }
  std::uint8_t& flags(int pixel) { return flags_[static_cast<std::size_t>(pixel)]; }
  int x(int pixel) const { return pixel % pitch_ - 1; }
  int y(int pixel) const { return pixel / pitch_ - 1; }

  /// Deletes a pixel and calls visit(neighbour) for each of its neighbours that is still set.
  template <class Visit>
  void remove(int pixel, const Visit& visit) {
    set_[static_cast<std::size_t>(pixel)] = 0;
    for (int i = 0; i < 8; ++i) {
      const int neighbour = pixel + offsets_[i];
      code_[static_cast<std::size_t>(neighbour)] &= static_cast<std::uint8_t>(~(1u << opposite(i)));
      if (has(neighbour)) visit(neighbour);
    }
  }
  /// visit(neighbour) for each set neighbour.
  template <class Visit>
  void for_each_neighbour(int pixel, const Visit& visit) const {
    for (int i = 0; i < 8; ++i)
      if (has(pixel + offsets_[i])) visit(pixel + offsets_[i]);
  }

 private:
  static constexpr int opposite(int i) { return (i + 4) % 8; }

  int pitch_ = 0;
  int offsets_[8] = {};
  std::vector<std::uint8_t> set_, code_, flags_;
};

}  // namespace facet
