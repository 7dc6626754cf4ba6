#pragma once

#include <cstdint>
#include <vector>

#include "core/image.hpp"
#include "cpu/sparse_mask.hpp"
#include "stage/fill_missing.hpp"

namespace facet {

/// The pass in which a shared value was computed last.
struct PassStamp {
  int mean = 0, offer = 0;
};

/// Memory of the tuned CPU stages, kept from frame to frame.
struct CpuScratch {
  std::vector<int> list_a, list_b, list_c, row_starts, names;
  SparseMask mask;
  Image<float> values, means;
  Image<FillOffer> offers;
  Image<PassStamp> stamps;
  std::vector<std::int64_t> sums;
};

}  // namespace facet
