#include "cpu/tuned/ownership.hpp"

#include <utility>

#include "core/clones.hpp"
#include "cpu/tuned/edge_list.hpp"
#include "stage/ownership.hpp"

namespace facet {
namespace {

constexpr std::uint8_t waiting = 2;  ///< open pixel that stands in the list already

FACET_CPU_CLONES void mark_labelled(const std::uint16_t* label, int width, std::uint8_t* labelled) {
  for (int x = 0; x < width; ++x) labelled[x] = label[x] != 0;
}

/// Lists the open pixels beside a labelled one.
void list_front(CpuScratch& scratch, ImageView<const std::uint16_t> label, ImageView<const std::uint8_t> open,
                std::vector<int>& front) {
  BitMask &beside = scratch.bits[0], &spare = scratch.bits[1];
  beside.assign_rows(label.size(),
                     [&](int y, std::uint8_t* bytes) { mark_labelled(label.row(y), label.width, bytes); });
  dilate_square(1, beside, spare);
  spare.assign(open);
  intersect(beside, spare);
  front.clear();
  for_each_set(beside, [&](int x, int y) { front.push_back(listed(x, y)); });
}

}  // namespace

void give_back_pixels(CpuExecutor& executor, float jump_ratio, float noise_sigmas, const DepthNoise& noise,
                      ImageView<const float> depth_m, ImageView<std::uint16_t> label,
                      ImageView<std::uint8_t> open, ImageView<std::uint16_t> choice) {
  std::vector<int>&front = executor.scratch().list_a, &next = executor.scratch().list_b;
  executor.for_each_pixel(label.size(), UnownedOp{depth_m, label, open});
  list_front(executor.scratch(), label, open, front);
  const ChooseOwnerOp choose{depth_m, label, jump_ratio, noise_sigmas, noise, choice};
  while (!front.empty()) {
    for (const int i : front) {
      const int x = x_of(i), y = y_of(i);
      if (x > 0 && y > 0 && x < label.width - 1 && y < label.height - 1)
        choose(x, y, InteriorAccess{});
      else
        choose(x, y, GuardedAccess{});
    }
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
