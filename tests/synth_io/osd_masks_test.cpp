// The annotations of real frames below FACET_DATA agree with their object masks; skipped where they are
// absent.
#include <gtest/gtest.h>

#include "support/real_data.hpp"
#include "synth_io/validate_benchmark.hpp"

namespace facet {
namespace {

TEST(OsdMasks, EveryAnnotatedObjectHasPixelsInTheMaskOfItsFrame) {
  FACET_REQUIRE_DATA("osd/truth");
  const auto report =
      validate_annotations(real_data_root() / "osd/truth", real_data_root() / "osd/annotation");
  EXPECT_EQ(report.frames, 3u);
  EXPECT_TRUE(report.problems.empty()) << report.problems[0];
}

}  // namespace
}  // namespace facet
