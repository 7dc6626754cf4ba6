#include "cpu/tuned/hysteresis.hpp"

#include "cpu/tuned/edge_list.hpp"
#include "stage/ridge.hpp"

namespace facet {

void hysteresis(CpuExecutor& executor, ImageView<std::uint8_t> ridge, ImageView<std::uint8_t> edge) {
  std::vector<int>&stack = executor.scratch().list_a, &ridges = executor.scratch().list_b;
  list_set_pixels(ridge, ridges);
  executor.fill(edge, std::uint8_t{0});
  stack.clear();
  for (const int i : ridges) {
    const int x = x_of(i), y = y_of(i);
    if (ridge(x, y) != static_cast<std::uint8_t>(Ridge::strong)) continue;
    edge(x, y) = 1;
    stack.push_back(i);
  }
  while (!stack.empty()) {
    const int from = stack.back();
    stack.pop_back();
    for_each_set_neighbour(ridge, from, [&](int x, int y) {
      if (edge(x, y)) return;
      edge(x, y) = 1;
      stack.push_back(listed(x, y));
    });
  }
}

}  // namespace facet
