#include "surface/renumber.hpp"

#include <algorithm>

#include "core/clones.hpp"

namespace facet {
namespace {

FACET_CPU_CLONES void renumber_row(const std::int32_t* from, const std::int32_t* number, int width,
                                   std::int32_t* to) {
#pragma GCC ivdep
  for (int x = 0; x < width; ++x) {
    const std::int32_t replaced = number[std::max(from[x], 0)];
    to[x] = from[x] < 0 ? -1 : replaced;
  }
}

}  // namespace

void renumber(HostThreads& threads, ImageView<const std::int32_t> from,
              const std::vector<std::int32_t>& number, ImageView<std::int32_t> to) {
  if (number.empty())
    return threads.for_each_row(to.height, [&](int y) { std::fill_n(to.row(y), to.width, -1); });
  threads.for_each_row(to.height,
                       [&](int y) { renumber_row(from.row(y), number.data(), to.width, to.row(y)); });
}

}  // namespace facet
