#pragma once

#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>

namespace facet {

/// The folder that the environment's FACET_DATA names, empty where it names none.
inline std::filesystem::path real_data_root() {
  const char* root = std::getenv("FACET_DATA");
  return root ? root : "";
}

}  // namespace facet

/// Skips the test, saying why, where FACET_DATA is not set or has no folder of that name.
#define FACET_REQUIRE_DATA(folder)                                              \
  if (facet::real_data_root().empty()) GTEST_SKIP() << "FACET_DATA is not set"; \
  if (!std::filesystem::is_directory(facet::real_data_root() / (folder)))       \
  GTEST_SKIP() << "FACET_DATA has no folder " << (folder)
