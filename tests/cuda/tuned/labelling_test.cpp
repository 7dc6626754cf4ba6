#include "cuda/tuned/labelling.hpp"

#include <gtest/gtest.h>

#include "support/masks.hpp"
#include "support/ridges.hpp"
#include "support/same_image.hpp"
#include "support/shuffled_grid.hpp"

namespace facet {
namespace {

void expect_plain_labels(const Image<float>& depth, const Mask& edge) {
  Image<std::int32_t> expected(depth.size()), result(depth.size());
  ShuffledGridExecutor plain(1);
  label_components(plain, depth.view(), edge.view(), expected.view());
  for (const unsigned order : {1u, 2u}) {
    ShuffledGridExecutor grid(order);
    result.fill(77);
    label_runs(grid, depth.view(), edge.view(), result.view());
    EXPECT_TRUE(same_image(result, expected)) << "order " << order;
  }
}

TEST(LabelRuns, GivesWhatThePlainOperationGives) {
  for_each_awkward_mask([](const Mask& edge) { expect_plain_labels(random_depth(edge.size(), 3), edge); });
}

TEST(LabelRuns, JoinsTheTurnsOfASpiral) {
  for (const int side : {31, 33, 97})
    expect_plain_labels(Image<float>(Size{side, side}, 1.0f), spiral_mask(side));
}

TEST(LabelRuns, JoinsRunsAcrossTheEndsOfSegments) {
  const Image<float> depth(Size{3 * run_segment_px + 1, 3}, 1.0f);
  Mask comb(depth.size(), 0);  // the middle row is open at the ends of segments alone
  for (int x = 0; x < comb.width(); ++x) comb(x, 1) = x % run_segment_px != 0;
  expect_plain_labels(depth, comb);
}

}  // namespace
}  // namespace facet
