#include "cpu/tuned/morphology.hpp"

#include "cpu/pack_bits.hpp"

namespace facet {
namespace {

void open_square(int side_px, BitMask& mask, BitMask& spare) {
  erode_square(side_px / 2, mask, spare);
  dilate_square(side_px / 2, mask, spare);
}

}  // namespace

void morphology(CpuExecutor& executor, const MorphologyParams& params, ImageView<std::uint8_t> edge,
                ImageView<std::uint8_t>, ImageView<std::uint8_t>) {
  if (params.mode == MorphologyMode::none) return;
  auto& bits = executor.scratch().bits;
  BitMask &mask = bits[0], &coarse = bits[1], &spare = bits[2];
  pack(executor, edge, mask);
  if (params.mode == MorphologyMode::bridge) {
    dilate_square(params.bridge_px, mask, spare);
  } else {
    dilate_square(1, mask, spare);
    open_square(params.small_element_px, mask, spare);
    coarse = mask;
    open_square(params.large_element_px, coarse, spare);
    subtract(mask, coarse);
  }
  unpack(executor, mask, edge);
}

}  // namespace facet
