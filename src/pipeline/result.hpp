#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/image.hpp"
#include "core/window_use.hpp"
#include "pipeline/frame_input.hpp"
#include "pipeline/stage_id.hpp"
#include "surface/surface.hpp"

namespace facet {

/// Wall times of one frame [ms].
struct StageTimes {
  std::array<double, stage_count> stage_ms{};
  double total_ms = 0;  ///< decoded depth in memory to contours, poses and labels in memory

  double unattributed_ms() const {
    double sum = 0;
    for (double ms : stage_ms) sum += ms;
    return total_ms - sum;
  }
};

/// Output of the pipeline for one frame. Reused from frame to frame, so that its memory is kept.
struct FrameResult {
  Image<std::uint16_t> labels;  ///< surfaces, 0 = none (see Prediction)
  Image<std::uint8_t> edges;    ///< edge kinds (see EdgeKind)
  std::vector<Surface> surfaces;
  std::vector<RejectedRegion> rejected;
  std::string note;  ///< why there is no surface at all, empty otherwise
  WindowUse window;  ///< frames that were averaged
  StageTimes times;
};

}  // namespace facet
