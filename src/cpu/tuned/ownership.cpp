#include "cpu/tuned/ownership.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "core/clones.hpp"
#include "cpu/pack_bits.hpp"
#include "cpu/tuned/edge_list.hpp"
#include "stage/ownership.hpp"

namespace facet {
namespace {

constexpr std::uint8_t waiting = 2;  ///< open pixel that stands in the list already

FACET_CPU_CLONES void mark_labelled(const std::uint16_t* label, int width, std::uint8_t* labelled) {
  for (int x = 0; x < width; ++x) labelled[x] = label[x] != 0;
}

/// Lists the open pixels beside a labelled one.
void list_front(CpuExecutor& executor, ImageView<const std::uint16_t> label,
                ImageView<const std::uint8_t> open, std::vector<int>& front) {
  BitMask &beside = executor.scratch().bits[0], &spare = executor.scratch().bits[1];
  pack_rows(executor, label.size(), beside,
            [&](int y, std::uint8_t* bytes) { mark_labelled(label.row(y), label.width, bytes); });
  dilate_square(1, beside, spare);
  pack(executor, open, spare);
  intersect(beside, spare);
  front.clear();
  for_each_set(beside, [&](int x, int y) { front.push_back(listed(x, y)); });
}

/// Lists the open neighbours of those pixels of the front that were given to a surface. Inside the image
/// without branches, which would be guessed wrong: whatever is looked at is written, and counted or not.
std::span<const int> list_open_beside(std::span<const int> front, ImageView<const std::uint16_t> choice,
                                      ImageView<std::uint8_t> open, std::vector<int>& list) {
  list.resize(std::max(list.size(), 8 * front.size() + 1));
  int* end = list.data();
  const auto look_at = [&](int x, int y) {
    std::uint8_t& state = open(x, y);
    *end = listed(x, y);
    end += state == 1;
    state = state == 1 ? waiting : state;
  };
  for (const int i : front) {
    const int x = x_of(i), y = y_of(i);
    if (choice(x, y) == 0) continue;
    const bool inside = x > 0 && y > 0 && x < open.width - 1 && y < open.height - 1;
    FACET_UNROLL for (int k = 0; k < 8; ++k) {
      const int nx = x + neighbour8(k).dx, ny = y + neighbour8(k).dy;
      if (inside || open.size().contains(nx, ny)) look_at(nx, ny);
    }
  }
  return {list.data(), end};
}

}  // namespace

void give_back_pixels(CpuExecutor& executor, float jump_ratio, float noise_sigmas, const DepthNoise& noise,
                      ImageView<const float> depth_m, ImageView<std::uint16_t> label,
                      ImageView<std::uint8_t> open, ImageView<std::uint16_t> choice) {
  std::vector<int>&list = executor.scratch().list_a, &next = executor.scratch().list_b;
  executor.for_each_pixel(label.size(), UnownedOp{depth_m, label, open});
  list_front(executor, label, open, list);
  const ChooseOwnerOp choose{depth_m, label, jump_ratio, noise_sigmas, noise, choice};
  for (std::span<const int> front = list; !front.empty(); std::swap(list, next)) {
    executor.for_each_part(front.size(), 512, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (const int i : front.subspan(begin, end - begin))
        CpuExecutor::run_pixel(choose, label.size(), x_of(i), y_of(i));
    });
    executor.for_each_part(front.size(), 1024, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (const int i : front.subspan(begin, end - begin)) {
        const int x = x_of(i), y = y_of(i);
        label(x, y) = choice(x, y);
        open(x, y) = choice(x, y) == 0;
      }
    });
    front = list_open_beside(front, choice, open, next);
  }
}

}  // namespace facet
