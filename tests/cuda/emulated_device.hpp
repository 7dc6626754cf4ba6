#pragma once

#include <gtest/gtest.h>

#include "core/image.hpp"
#include "cuda/emulated_runtime.hpp"
#include "cuda/stream_executor.cuh"
#include "cuda/tuned/overloads.cuh"

namespace facet {

/// The executor of the back end, its streams and copies included, on an emulated device.
using EmulatedExecutor = StreamExecutor<EmulatedKernels>;

/// An awkward size of the frames.
inline constexpr Size emulated_size{101, 75};
/// Then the temporal average has five frames, and the latest has been twice in each of their places.
inline constexpr int frames_until_steady = 14;

class EmulatedDevice : public testing::Test {
 protected:
  void SetUp() override { emulated_runtime() = {}; }
};

}  // namespace facet
