#include <gtest/gtest.h>

#include "cpu/cpu_pipeline.hpp"
#include "pipeline/small_scene.hpp"
#include "stream/stream.hpp"

namespace facet {
namespace {

TEST(StreamMemory, StaysWithinFivePercentAfterWarmUp) {
  const Camera camera = kinect_v1_camera();
  std::vector<Image<float>> depth_m;
  for (std::size_t i = 0; i < 6; ++i) depth_m.push_back(small_measured_scene(i, kinect_v1_size(), camera, i));
  std::vector<FrameInput> frames;
  for (const Image<float>& image : depth_m) frames.push_back({image.view(), camera});
  StreamOptions options;
  options.pace = StreamPace::fastest;
  options.frames = 600;
  StageFilters filters(options, [](int count) { return make_cpu_pipelines(count, {}, 1); });
  filters.warm_up(frames.front());
  const std::atomic<int> stop_signal = 0;
  const std::vector<double> stamps_s(frames.size());
  const StreamRecord record = run_stream(
      frames, FrameSchedule(options, stamps_s), options, filters, [](Passage&) {}, stop_signal);
  ASSERT_EQ(record.samples.size(), 600u);
  EXPECT_GT(record.memory.after_warmup_mb, 50);
  EXPECT_LT(record.memory.max_mb, 1.05 * record.memory.after_warmup_mb);
}

}  // namespace
}  // namespace facet
