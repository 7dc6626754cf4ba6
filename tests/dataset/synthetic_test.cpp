#include "dataset/synthetic.hpp"

#include <algorithm>
#include <gtest/gtest.h>

#include "support/expect_error.hpp"

namespace facet {
namespace {

DatasetSpec synthetic_spec() {
  DatasetSpec spec;
  spec.name = spec.reader = "synthetic";
  return spec;
}

TEST(SyntheticReader, makes_frames_with_everything_a_recording_has) {
  const auto data = open_dataset(synthetic_spec());
  ASSERT_GE(data->size(), 3u);
  const Frame frame = data->load(1);
  EXPECT_EQ(frame.id, data->frame_id(1));
  ASSERT_FALSE(frame.depth_m.empty());
  EXPECT_EQ(frame.color.cols, frame.depth_m.width());
  EXPECT_EQ(frame.color.type(), CV_8UC3);
  ASSERT_TRUE(frame.object_masks.has_value());
  EXPECT_EQ(frame.object_masks->type(), CV_16UC1);
  EXPECT_GT(frame.missing_px, 0u);
  EXPECT_LT(frame.missing_px, static_cast<std::size_t>(frame.depth_m.size().area()) / 2);
  EXPECT_GT(frame.camera.fx, 0);
  EXPECT_EQ(data->sensor(), Sensor::kinect_v1);
}

TEST(SyntheticReader, without_noise_misses_nothing_that_the_camera_sees) {
  DatasetSpec spec = synthetic_spec();
  const Frame noisy = open_dataset(spec)->load(0);
  spec.options = {{"noise", "false"}};
  const Frame exact = open_dataset(spec)->load(0);
  EXPECT_LT(exact.missing_px, noisy.missing_px);
}

TEST(SyntheticReader, a_selected_frame_is_the_same_as_in_the_whole_set) {
  DatasetSpec spec = synthetic_spec();
  const auto whole = open_dataset(spec);
  spec.frames = {whole->frame_id(2)};
  const Frame alone = open_dataset(spec)->load(0);
  const Frame among = whole->load(2);
  EXPECT_EQ(alone.id, among.id);
  for (int y = 0; y < alone.depth_m.height(); ++y)
    ASSERT_TRUE(
        std::equal(alone.depth_m.row(y), alone.depth_m.row(y) + alone.depth_m.width(), among.depth_m.row(y)));
}

TEST(SyntheticReader, another_seed_gives_other_depth) {
  DatasetSpec spec = synthetic_spec();
  const Frame first = open_dataset(spec)->load(0);
  spec.options = {{"seed", "2"}};
  const Frame second = open_dataset(spec)->load(0);
  int different = 0;
  for (int y = 0; y < first.depth_m.height(); ++y)
    for (int x = 0; x < first.depth_m.width(); ++x) different += first.depth_m(x, y) != second.depth_m(x, y);
  EXPECT_GT(different, first.depth_m.size().area() / 10);
}

TEST(SyntheticReader, refuses_unknown_scenes_and_seeds_that_are_no_whole_number) {
  DatasetSpec spec = synthetic_spec();
  spec.options = {{"scenes", "moon"}};
  expect_error(ErrorKind::config, "moon", [&] { open_dataset(spec); });
  for (const char* seed : {"1.5", "-1", "1e300"}) {
    spec.options = {{"seed", seed}};
    expect_error(ErrorKind::config, "option seed: expected a whole number", [&] { open_dataset(spec); });
  }
}

}  // namespace
}  // namespace facet
