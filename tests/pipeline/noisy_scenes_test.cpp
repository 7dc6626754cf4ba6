#include <fmt/core.h>
#include <gtest/gtest.h>

#include "cpu/cpu_pipeline.hpp"
#include "pipeline/face_match.hpp"
#include "pipeline/modes.hpp"
#include "synth/synthetic_frame.hpp"

namespace facet {
namespace {

/// The plane-and-box scene as Kinect v1 measures it.
SyntheticFrame measured_frame(int seed) {
  return make_frame({.scenes = "plane_and_box", .seed = static_cast<std::uint64_t>(seed)}, 0);
}

/// The robustification steps one after the other, on top of the naive pipeline, as the paper has them.
std::vector<Mode> cumulative_steps() {
  const PipelineParams paper = paper_params();
  std::vector<Mode> steps{{"none", naive_params()}};
  const auto add = [&](const char* name, const auto& change) {
    steps.push_back({name, steps.back().params});
    change(steps.back().params);
  };
  add("+Wiener", [&](PipelineParams& p) { p.wiener = paper.wiener; });
  add("+Sobel", [&](PipelineParams& p) { p.gradient = paper.gradient; });
  add("+smoothing", [&](PipelineParams& p) { p.morphology = paper.morphology, p.pruning = paper.pruning; });
  return steps;
}

void expect_false_regions_to_fall(int seeds) {
  long before = std::numeric_limits<long>::max();
  for (const Mode& step : cumulative_steps()) {
    long count = 0;
    const auto pipeline = make_cpu_pipeline(step.params, 1);
    FrameResult result;
    for (int seed = 1; seed <= seeds; ++seed) {
      const SyntheticFrame frame = measured_frame(seed);
      pipeline->process({frame.depth_m.view(), frame.camera}, result);
      count += false_regions(frame.exact.surface_ids, result);
    }
    fmt::print("{:12} {:8.1f} false regions per frame\n", step.name, static_cast<double>(count) / seeds);
    EXPECT_LT(count, before) << step.name;
    before = count;
  }
}

TEST(NoisyScenes, FalseRegionsFallWithEveryStepOfThePaper) {
  expect_false_regions_to_fall(2);
}

TEST(SlowNoisyScenes, FalseRegionsFallWithEveryStepOfThePaperOver20Seeds) {
  expect_false_regions_to_fall(20);
}

/// Counts the frames in which the default pipeline finds every face at an IoU of 0.8, and its false regions.
void expect_faces_in_most_frames(int seeds) {
  int whole = 0, wrong = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    const SyntheticFrame frame = measured_frame(seed);
    FrameResult result;
    make_cpu_pipeline({}, 1)->process({frame.depth_m.view(), frame.camera}, result);
    const auto faces = match_faces(frame.exact.surface_ids, result.labels);
    ASSERT_EQ(faces.size(), 4u);
    whole += all_found(faces, 0.8);
    wrong += false_regions(frame.exact.surface_ids, result);
  }
  fmt::print("every face in {} of {} frames, {} false regions\n", whole, seeds, wrong);
  EXPECT_GE(whole, 0.9 * seeds);
  EXPECT_LE(wrong, 0.5 * seeds);
}

TEST(NoisyScenes, TheDefaultPipelineFindsEveryFaceForMostSeeds) {
  expect_faces_in_most_frames(4);
}

TEST(SlowNoisyScenes, TheDefaultPipelineFindsEveryFaceForMostOf40Seeds) {
  expect_faces_in_most_frames(40);
}

}  // namespace
}  // namespace facet
