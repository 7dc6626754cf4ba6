#include "cpu/tuned/relocate.hpp"

#include <gtest/gtest.h>

#include "stage/depth_edges.hpp"
#include "support/every_executor.hpp"
#include "support/masks.hpp"

namespace facet {
namespace {

template <class Executor>
Mask relocated(Executor& executor, const Image<float>& depth, const Mask& edge) {
  const Mask direction = make_image<std::uint8_t>(
      depth.size(), [](int x, int y) { return static_cast<int>(4 * noise_at(8, x, y)); });
  Mask out(depth.size(), 9);
  relocate_to_occluding_side(executor, depth.view(), direction.view(), edge.view(), out.view());
  return out;
}

TEST(TunedRelocation, GivesWhatThePlainOperationGives) {
  for_each_awkward_depth([](const Image<float>& depth) {
    for (const Mask& edge : {line_mask(depth.size(), 2), random_mask(depth.size(), 3, 0.3f)})
      expect_same_on_every_executor([&](auto& executor) { return relocated(executor, depth, edge); });
  });
}

}  // namespace
}  // namespace facet
