#pragma once

#include <map>
#include <string>
#include <vector>

#include "pipeline/stage_id.hpp"

namespace facet {

/// Bytes per pixel that a stage moves in each mode: those of the images that it reads and writes, each
/// counted once per pass over it. 0: it touches no whole image.
struct StageTraffic {
  static constexpr int idle = -1;  ///< the stage does nothing in that mode
  StageId id;
  std::map<std::string, int> bytes_per_px;
};
const std::vector<StageTraffic>& stage_traffic();

}  // namespace facet
