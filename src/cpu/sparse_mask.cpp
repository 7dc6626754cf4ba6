#include "cpu/sparse_mask.hpp"

#include "core/neighbours.hpp"
#include "cpu/sparse_row.hpp"

namespace facet {

void SparseMask::assign(ImageView<const std::uint8_t> mask, std::vector<int>& pixels) {
  pitch_ = mask.width + 2;
  for (int i = 0; i < 8; ++i) offsets_[i] = neighbour8(i).dy * pitch_ + neighbour8(i).dx;
  const auto count = static_cast<std::size_t>(pitch_) * static_cast<std::size_t>(mask.height + 2);
  set_.assign(count, 0);
  code_.assign(count, 0);
  flags_.assign(count, 0);
  pixels.clear();
  const auto add = [&](int x, int y) {
    const int pixel = (y + 1) * pitch_ + x + 1;
    set_[static_cast<std::size_t>(pixel)] = 1;
    pixels.push_back(pixel);
    for (int i = 0; i < 8; ++i)
      code_[static_cast<std::size_t>(pixel + offsets_[i])] |= static_cast<std::uint8_t>(1u << opposite(i));
  };
  for (int y = 0; y < mask.height; ++y)
    for_each_set_in_row(mask.row(y), mask.width, [&](int x) { add(x, y); });
}

}  // namespace facet
