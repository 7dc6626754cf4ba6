#include "synth/synthetic_frame.hpp"

#include <gtest/gtest.h>
#include <set>

#include "core/error.hpp"

namespace facet {
namespace {

TEST(SyntheticFrame, QuickstartHasSixDistinctScenesWithAllTheirObjectsInView) {
  const SyntheticSpec spec;
  const auto ids = frame_ids(spec);
  ASSERT_EQ(ids.size(), 6u);
  EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()).size(), 6u);
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const SyntheticFrame frame = make_frame(spec, k);
    EXPECT_EQ(frame.id, ids[k]);
    std::set<int> seen;
    for (int y = 0; y < 480; ++y) {
      for (int x = 0; x < 640; ++x) seen.insert(frame.exact.object_ids(x, y));
    }
    EXPECT_EQ(seen.size(), frame.view.scene.objects.size() + 1) << frame.id;
  }
}

TEST(SyntheticFrame, TheSameSpecGivesTheSameBytes) {
  const SyntheticFrame a = make_frame({}, 4), b = make_frame({}, 4);
  for (int y = 0; y < 480; ++y) {
    for (int x = 0; x < 640; ++x) {
      ASSERT_EQ(a.depth_m(x, y), b.depth_m(x, y));
      ASSERT_EQ(a.exact.colour(x, y), b.exact.colour(x, y));
    }
  }
}

TEST(SyntheticFrame, NoiseFreeFramesHoldTheExactDepth) {
  const SyntheticFrame frame = make_frame({.scenes = "plane_and_box", .noise_free = true}, 0);
  for (int x = 0; x < 640; ++x) ASSERT_EQ(frame.depth_m(x, 200), frame.exact.depth_m(x, 200));
}

TEST(SyntheticFrame, EveryFamilyCanBeNamedAndHasDistinctFrames) {
  for (const std::string& scenes : synthetic_scene_sets()) {
    const auto ids = frame_ids({.scenes = scenes});
    EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()).size(), ids.size()) << scenes;
  }
  const SyntheticFrame frame = make_frame({.scenes = "stacked_boxes"}, 3);
  EXPECT_EQ(frame.id, "stacked_boxes_3");
  EXPECT_GE(frame.view.scene.objects.size(), 4u);
}

TEST(SyntheticFrame, AnUnknownSetOrIndexIsAConfigError) {
  EXPECT_THROW(frame_ids({.scenes = "nonsense"}), Error);
  EXPECT_THROW(make_frame({.scenes = "plane_and_box"}, 1), Error);
}

}  // namespace
}  // namespace facet
