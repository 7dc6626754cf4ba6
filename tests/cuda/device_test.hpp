#pragma once

#include <cstdlib>
#include <gtest/gtest.h>
#include <string_view>

#include "cuda/cuda_pipeline.hpp"

namespace facet {

/// Whether a missing device is a failure: FACET_REQUIRE_GPU=1.
inline bool requires_device() {
  const char* value = std::getenv("FACET_REQUIRE_GPU");
  return value != nullptr && std::string_view(value) == "1";
}

/// Tests that need a CUDA device: skipped where there is none, with the reason.
template <class Base = testing::Test>
class DeviceTest : public Base {
 protected:
  void SetUp() override {
    static const std::string unusable = find_cuda_support().unusable;
    if (unusable.empty()) return;
    if (requires_device()) FAIL() << "FACET_REQUIRE_GPU=1, but " << unusable;
    GTEST_SKIP() << "no CUDA device: " << unusable;
  }
};

}  // namespace facet
