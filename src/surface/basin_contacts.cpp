#include "surface/basin_contacts.hpp"

#include <algorithm>

#include "core/changes.hpp"

namespace facet {

void collect_contacts(const BasinLandscape& landscape, ImageView<const std::int32_t> region, int begin_y,
                      int end_y, std::vector<BasinContact>& contacts) {
  contacts.clear();
  for_each_change(region, begin_y, end_y, [&](int x, int y, bool down) {
    const int other_x = down ? x : x + 1, other_y = down ? y + 1 : y;
    const std::int32_t here = region(x, y), there = region(other_x, other_y);
    if (here < 0 || there < 0) return;
    contacts.push_back({std::min(here, there), std::max(here, there),
                        2 * (y * region.width + x) + (down ? 1 : 0),
                        std::max(landscape.strength(x, y), landscape.strength(other_x, other_y))});
  });
}

}  // namespace facet
