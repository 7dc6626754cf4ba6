#pragma once

#include "pipeline/stage_id.hpp"

namespace facet {

/// Consecutive stages, both ends included.
struct StageRange {
  StageId first = StageId::temporal;
  StageId last = StageId::objects;

  constexpr bool contains(StageId id) const { return first <= id && id <= last; }
};
inline constexpr StageRange all_stages;
static_assert(index_of(all_stages.last) == stage_count - 1);

}  // namespace facet
