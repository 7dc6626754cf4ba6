#pragma once

namespace facet {

enum class WienerGain {
  paper,  ///< eq. 2 as printed: var / (var + noise)
  lim,    ///< Lim 1990: max(0, var - noise) / max(var, noise)
};
enum class WienerNoise {
  sensor,  ///< the sensor's noise model at the pixel's depth
  mean,    ///< mean of all local variances (the paper)
};

struct WienerParams {
  bool enabled = true;
  WienerGain gain = WienerGain::lim;
  WienerNoise noise = WienerNoise::sensor;
  int window_px = 5;    ///< side of the square window, odd [px], 3..15
  bool detrend = true;  ///< subtract the local plane's slope from the variance, so that a slope is not signal
};

}  // namespace facet
