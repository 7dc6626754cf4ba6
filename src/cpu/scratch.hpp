#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/disjoint_sets.hpp"
#include "cpu/bit_mask.hpp"
#include "cpu/due_blocks.hpp"
#include "cpu/fill_grid.hpp"

namespace facet {

/// Memory of the tuned CPU stages, kept from frame to frame.
struct CpuScratch {
  std::vector<int> list_a, list_b, list_c, row_starts, names;
  DisjointSets sets;
  std::array<BitMask, 4> bits;
  std::vector<std::uint8_t> row, rows_due;
  DueBlocks due_blocks;
  FillGrid fill_grid;
  std::vector<FillOffers> fill_offers;  ///< one for each part of a pass
  std::vector<float> values;
};

}  // namespace facet
