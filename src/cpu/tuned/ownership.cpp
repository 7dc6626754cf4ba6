#include "cpu/tuned/ownership.hpp"

#include <utility>

#include "cpu/tuned/edge_list.hpp"
#include "stage/ownership.hpp"

namespace facet {
namespace {

constexpr std::uint8_t waiting = 2;  ///< open pixel that stands in the list already

}  // namespace

void give_back_pixels(CpuExecutor& executor, float jump_ratio, float noise_sigmas, const DepthNoise& noise,
                      ImageView<const float> depth_m, ImageView<std::uint16_t> label,
                      ImageView<std::uint8_t> open, ImageView<std::uint16_t> choice) {
  std::vector<int>&front = executor.scratch().list_a, &next = executor.scratch().list_b;
  executor.for_each_pixel(label.size(), UnownedOp{depth_m, label, open});
  list_set_pixels(open, front);
  const ChooseOwnerOp choose{depth_m, label, jump_ratio, noise_sigmas, noise, choice};
  while (!front.empty()) {
    for (const int i : front) choose(x_of(i), y_of(i), GuardedAccess{});
    next.clear();
    for (const int i : front) {
      const int x = x_of(i), y = y_of(i);
      label(x, y) = choice(x, y);
      open(x, y) = choice(x, y) == 0;
    }
    for (const int i : front) {
      if (choice(x_of(i), y_of(i)) == 0) continue;
      for_each_set_neighbour(open, i, [&](int x, int y) {
        if (open(x, y) == waiting) return;
        open(x, y) = waiting;
        next.push_back(listed(x, y));
      });
    }
    std::swap(front, next);
  }
}

}  // namespace facet
