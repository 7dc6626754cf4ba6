#pragma once

#include "cpu/scratch.hpp"
#include "stage/fill_missing.hpp"

namespace facet {

/// Sets `rim`, which is clear, where FillRimOp does. `missing`: 1 where there is no depth. Instead of
/// searching across holes it carries the last depth before a hole along rows, columns and diagonals.
void mark_rims(CpuScratch& scratch, const FillParams& params, ImageView<const float> depth_m,
               ImageView<const std::uint8_t> missing, ImageView<std::uint8_t> rim);

}  // namespace facet
