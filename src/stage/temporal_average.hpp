#pragma once

namespace facet {

enum class TemporalMode {
  mean,    ///< paper eq. 3: mean of the valid readings
  robust,  ///< mean of the readings within three sigma of their median: no mixing across a moving edge
};

struct TemporalParams {
  bool enabled = true;
  TemporalMode mode = TemporalMode::robust;
  int frames = 5;  ///< window, the current frame included [frames], 1..16
};

}  // namespace facet
