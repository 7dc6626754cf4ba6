#include "cpu/tuned/thinning.hpp"

#include "stage/thinning.hpp"

namespace facet {

void thin(CpuExecutor& executor, ImageView<std::uint8_t> edge, ImageView<std::uint8_t>) {
  SparseMask& mask = executor.scratch().mask;
  std::vector<int>* waiting[2] = {&executor.scratch().list_a, &executor.scratch().list_b};
  std::vector<int>& doomed = executor.scratch().list_c;
  mask.assign(edge, *waiting[0]);
  *waiting[1] = *waiting[0];
  for (const int pixel : *waiting[0]) mask.flags(pixel) = 3;  // bit h: waits in the list of half h
  while (!waiting[0]->empty() || !waiting[1]->empty()) {
    for (int half = 0; half < 2; ++half) {
      doomed.clear();
      for (const int pixel : *waiting[half]) {
        mask.flags(pixel) &= static_cast<std::uint8_t>(~(1 << half));
        if (mask.has(pixel) && thinning_tables[half][mask.code(pixel)]) doomed.push_back(pixel);
      }
      waiting[half]->clear();
      for (const int pixel : doomed) {
        edge(mask.x(pixel), mask.y(pixel)) = 0;
        mask.remove(pixel, [&](int neighbour) {
          for (int next = 0; next < 2; ++next) {
            if (mask.flags(neighbour) & (1 << next)) continue;
            mask.flags(neighbour) |= static_cast<std::uint8_t>(1 << next);
            waiting[next]->push_back(neighbour);
          }
        });
      }
    }
  }
}

}  // namespace facet
