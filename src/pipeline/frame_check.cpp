#include "pipeline/frame_check.hpp"

#include <cmath>
#include <string>

#include "core/error.hpp"

namespace facet {

void check_frame(const FrameInput& frame) {
  const Camera& c = frame.camera;
  if (!(c.fx > 0 && c.fy > 0 && std::isfinite(c.fx) && std::isfinite(c.fy)))
    throw Error(ErrorKind::data, "camera: focal lengths must be positive, got fx = " + std::to_string(c.fx) +
                                     ", fy = " + std::to_string(c.fy));
  if (!(std::isfinite(c.cx) && std::isfinite(c.cy)))
    throw Error(ErrorKind::data, "camera: the principal point must be finite, got cx = " +
                                     std::to_string(c.cx) + ", cy = " + std::to_string(c.cy));
  if (frame.counts && frame.counts->counts.size() != frame.depth_m.size())
    throw Error(ErrorKind::data, "depth: the image in whole units has another size than that in metres");
  for (int y = 0; y < frame.depth_m.height; ++y) {
    const float* row = frame.depth_m.row(y);
    bool good = true;
    for (int x = 0; x < frame.depth_m.width; ++x) good &= row[x] >= 0 && row[x] < 1e6f;
    if (!good)
      throw Error(ErrorKind::data, "depth: row " + std::to_string(y) +
                                       " holds a negative, infinite or NaN value; missing depth must be 0");
  }
}

}  // namespace facet
