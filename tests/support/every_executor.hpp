#pragma once

#include "cpu/executor.hpp"
#include "support/same_image.hpp"
#include "support/shuffled_grid.hpp"

namespace facet {

/// Runs `stage(executor)`, which returns an image or a tuple of images, on the shuffled grid in two orders of
/// its threads and on the CPU with one and with three threads, and expects the same result to the bit. Where
/// the test includes a tuned overload, that is what the CPU runs.
template <class Stage>
void expect_same_on_every_executor(const Stage& stage) {
  ShuffledGridExecutor grid(1), other_grid(2);
  CpuExecutor one_thread(1), three_threads(3);
  const auto expected = stage(grid);
  EXPECT_TRUE(same_image(stage(other_grid), expected)) << "grid, another order of threads";
  EXPECT_TRUE(same_image(stage(one_thread), expected)) << "CPU, one thread";
  EXPECT_TRUE(same_image(stage(three_threads), expected)) << "CPU, three threads";
}

}  // namespace facet
