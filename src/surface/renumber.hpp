#pragma once

#include <cstdint>
#include <vector>

#include "core/host_threads.hpp"
#include "core/image_view.hpp"

namespace facet {

/// Replaces every number k >= 0 of an image by number[k]; the others become -1. `to` may be `from`.
void renumber(HostThreads& threads, ImageView<const std::int32_t> from,
              const std::vector<std::int32_t>& number, ImageView<std::int32_t> to);

}  // namespace facet
