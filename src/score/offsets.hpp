#pragma once

#include <vector>

namespace facet {

/// A step on the pixel grid and its length.
struct GridOffset {
  int dx = 0, dy = 0;
  double length_px = 0;
};

/// All steps of at most that length, shortest first; those of equal length row by row.
std::vector<GridOffset> offsets_within(double radius_px);

/// Slack of comparisons with a tolerance, so that a distance of exactly the tolerance is within it [px].
inline constexpr double distance_slack_px = 1e-6;

}  // namespace facet
