#include <gtest/gtest.h>

#include "synth/frame_plan.hpp"
#include "synth_io/write_benchmark.hpp"

namespace facet {
namespace {

TEST(ShippedSpecs, AreReadWithoutAProblemAndHoldWhatTheirNamesPromise) {
  const std::filesystem::path folder = std::filesystem::path(FACET_CONFIGS) / "synth";
  const struct {
    const char* name;
    std::size_t frames;
  } specs[] = {{"quick", 12}, {"tabletop", 120}, {"table2", 8}, {"clutter", 200}, {"thin", 100}};
  for (const auto& expected : specs) {
    const BenchmarkSpec spec = read_benchmark_spec(folder / (std::string(expected.name) + ".yaml"));
    EXPECT_EQ(spec.name, expected.name);
    EXPECT_EQ(estimate_benchmark(spec).frames, expected.frames);
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    EXPECT_GT(estimate_benchmark(read_benchmark_spec(entry.path())).seconds, 1) << entry.path();
  }
}

TEST(ShippedSpecs, LevelsOutsideTheRangeOfASensorAreNotAvailable) {
  const BenchmarkSpec spec =
      read_benchmark_spec(std::filesystem::path(FACET_CONFIGS) / "synth/invariance.yaml");
  std::size_t absent = 0;
  for (const SetSpec& set : spec.sets) {
    for (const PlannedFrame& frame : plan_frames(set)) {
      if (frame.not_available.empty()) continue;
      EXPECT_EQ(frame.not_available, "n/a (range)");
      EXPECT_EQ(frame.level, 0.4);
      ++absent;
    }
  }
  EXPECT_EQ(absent, 20u);
}

}  // namespace
}  // namespace facet
