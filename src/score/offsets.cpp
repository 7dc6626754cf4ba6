#include "score/offsets.hpp"

#include <algorithm>
#include <cmath>

namespace facet {

std::vector<GridOffset> offsets_within(double radius_px) {
  const int reach = static_cast<int>(std::floor(radius_px + distance_slack_px));
  std::vector<GridOffset> offsets;
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const double length = std::hypot(dx, dy);
      if (length <= radius_px + distance_slack_px) offsets.push_back({dx, dy, length});
    }
  }
  std::stable_sort(offsets.begin(), offsets.end(),
                   [](const GridOffset& a, const GridOffset& b) { return a.length_px < b.length_px; });
  return offsets;
}

}  // namespace facet
