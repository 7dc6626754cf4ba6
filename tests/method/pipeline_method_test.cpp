#include "method/pipeline_method.hpp"

#include <gtest/gtest.h>

#include "support/expect_error.hpp"

namespace facet {
namespace {

/// Counts its calls and answers with a result that shows which call it was.
class CountingPipeline final : public Pipeline {
 public:
  CountingPipeline(int& calls, int& resets) : calls_(calls), resets_(resets) {}
  void run(StageRange, const FrameInput& frame, FrameResult& result) override {
    ++calls_;
    result.labels.resize(frame.depth_m.size());
    result.labels.fill(static_cast<std::uint16_t>(calls_));
    result.edges.resize(frame.depth_m.size());
    result.surfaces.assign(static_cast<std::size_t>(calls_), Surface{});
    result.rejected.clear();
    result.note = calls_ == 2 ? "second" : "";
    result.times.total_ms = calls_;
  }
  void reset_history() override { ++resets_; }

 private:
  int& calls_;
  int& resets_;
};

Frame frame_of(Size size) {
  Frame frame;
  frame.depth_m = Image<float>(size, 1.0f);
  frame.camera = {10, 10, 2, 2};
  return frame;
}

TEST(PipelineMethod, EveryPredictionIsTheResultOfItsOwnFrame) {
  int calls = 0, resets = 0;
  const auto method = wrap_pipeline(std::make_unique<CountingPipeline>(calls, resets));
  const Frame frame = frame_of({4, 3});
  Prediction prediction;
  StageTimes times;
  for (int call = 1; call <= 3; ++call) {
    method->process(frame, prediction, times);
    EXPECT_EQ(prediction.labels.size(), (Size{4, 3}));
    EXPECT_EQ(prediction.labels(3, 2), call);
    EXPECT_EQ(prediction.surfaces.size(), static_cast<std::size_t>(call));
    EXPECT_EQ(prediction.note, call == 2 ? "second" : "");
    EXPECT_EQ(times.total_ms, call);
  }
}

TEST(PipelineMethod, ForgettingThePastReachesThePipeline) {
  int calls = 0, resets = 0;
  wrap_pipeline(std::make_unique<CountingPipeline>(calls, resets))->reset_history();
  EXPECT_EQ(resets, 1);
}

TEST(PipelineMethod, AutoTakesTheSensorOfTheDataSet) {
  PipelineParams params;
  EXPECT_EQ(with_sensor(params, Sensor::stereo).sensor, Sensor::stereo);
  EXPECT_EQ(with_sensor(params, Sensor::automatic).sensor, Sensor::kinect_v1);
  params.sensor = Sensor::azure_kinect;
  EXPECT_EQ(with_sensor(params, Sensor::stereo).sensor, Sensor::azure_kinect);
}

TEST(MethodRegistry, MakesThePipelineAndNamesAnUnknownKind) {
  MethodSpec spec;
  EXPECT_NE(make_method(spec, {}), nullptr);
  spec.kind = "magic";
  expect_error(ErrorKind::config, "magic", [&] { make_method(spec, {}); });
}

TEST(MethodRegistry, AFlatWallIsOneSurface) {
  const auto method = make_method(MethodSpec{}, {});
  Frame frame = frame_of({64, 48});
  frame.camera = {60, 60, 31.5f, 23.5f};
  Prediction prediction;
  StageTimes times;
  method->process(frame, prediction, times);
  ASSERT_EQ(prediction.surfaces.size(), 1u) << prediction.note;
  EXPECT_GT(times.total_ms, 0);
}

}  // namespace
}  // namespace facet
