#include "cpu/tuned/hysteresis.hpp"

#include "core/neighbours.hpp"
#include "stage/ridge.hpp"

namespace facet {

void hysteresis(CpuExecutor& executor, ImageView<std::uint8_t> ridge, ImageView<std::uint8_t> edge) {
  std::vector<int>& stack = executor.scratch().list_a;
  stack.clear();
  for (int y = 0; y < ridge.height; ++y)
    for (int x = 0; x < ridge.width; ++x) {
      const bool strong = ridge(x, y) == static_cast<std::uint8_t>(Ridge::strong);
      edge(x, y) = strong;
      if (strong) stack.push_back(y * ridge.width + x);
    }
  while (!stack.empty()) {
    const int x = stack.back() % ridge.width, y = stack.back() / ridge.width;
    stack.pop_back();
    for (int i = 0; i < 8; ++i) {
      const int nx = x + neighbour8(i).dx, ny = y + neighbour8(i).dy;
      if (!edge.size().contains(nx, ny) || edge(nx, ny) || !ridge(nx, ny)) continue;
      edge(nx, ny) = 1;
      stack.push_back(ny * ridge.width + nx);
    }
  }
}

}  // namespace facet
