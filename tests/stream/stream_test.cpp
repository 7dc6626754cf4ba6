#include "stream/stream.hpp"

#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>

#include "cpu/cpu_pipeline.hpp"
#include "pipeline/modes.hpp"
#include "pipeline/small_scene.hpp"
#include "prediction/prediction_io.hpp"
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

namespace facet {
namespace {

constexpr Size size{160, 120};

/// Frames of a still scene and of another one, with noise of their own: what one frame gives depends on those
/// before.
class Stream : public ::testing::Test {
 protected:
  Stream() {
    for (std::uint64_t i = 0; i < 8; ++i) {
      depth_m_.push_back(small_measured_scene(i < 5 ? 1 : 4, size, camera_, i));
      stamps_s_.push_back(static_cast<double>(i) / 30);
    }
    for (const Image<float>& depth_m : depth_m_) frames_.push_back({depth_m.view(), camera_});
    options_.pace = StreamPace::fastest;
    options_.frames = 20;  // two and a half rounds
    options_.warmup = 2;
  }
  StreamRecord run(
      const PipelineParams& params, const FrameSink& sink = [](Passage&) {}) {
    StageFilters filters(options_,
                         [&](int count) { return make_cpu_pipelines(count, params, 7, threads_in_frame_); });
    filters.warm_up(frames_.front());
    return run_stream(frames_, FrameSchedule(options_, stamps_s_), options_, filters, sink, stop_signal_);
  }
  /// Name -> content of the three files of a prediction.
  std::vector<std::string> bytes_of(FrameResult& result) const {
    const Prediction prediction{result.labels, result.edges, result.surfaces, result.rejected, {},
                                result.note,   result.window};
    const PredictionFiles files(folder_.path() / "frame");
    write_prediction(prediction, folder_.path() / "frame");
    std::vector<std::string> bytes;
    for (const auto& file : {files.labels, files.edges, files.surfaces}) {
      std::ifstream input(file, std::ios::binary);
      bytes.emplace_back(std::istreambuf_iterator<char>(input), std::istreambuf_iterator<char>());
    }
    return bytes;
  }
  std::vector<std::vector<std::string>> serial_predictions(const PipelineParams& params) const {
    const auto pipeline = make_cpu_pipeline(params, 7);
    std::vector<std::vector<std::string>> predictions;
    FrameResult result;
    for (int i = 0; i < options_.frames; ++i) {
      pipeline->process(frames_[static_cast<std::size_t>(i) % frames_.size()], result);
      predictions.push_back(bytes_of(result));
    }
    return predictions;
  }

  const Camera camera_ = scaled_camera(size);
  const TemporaryFolder folder_;
  std::vector<Image<float>> depth_m_;
  std::vector<FrameInput> frames_;
  std::vector<double> stamps_s_;
  StreamOptions options_;
  int threads_in_frame_ = 1;
  std::atomic<int> stop_signal_ = 0;
};

TEST_F(Stream, PredictionsEqualThoseOfASerialRunByteForByteForEveryCut) {
  const std::vector<std::vector<StreamFilter>> cuts{
      {{"all", StageId::objects, 1}},
      StreamOptions{}.filters,
      {{"average", StageId::temporal, 1}, {"rest", StageId::objects, 4}},
      {{"a", StageId::fill, 1},
       {"b", StageId::depth_canny, 3},
       {"c", StageId::labelling, 2},
       {"d", StageId::objects, 2}}};
  for (const Mode& mode : modes) {
    const auto expected = serial_predictions(mode.params);
    for (const std::vector<StreamFilter>& cut : cuts) {
      options_.filters = cut;
      std::size_t next = 0;
      const StreamRecord record = run(mode.params, [&](Passage& passage) {
        ASSERT_EQ(passage.number, next);
        EXPECT_EQ(bytes_of(passage.workspace->result), expected[next++])
            << mode.name << ", frame " << passage.number << ", " << cut.size() << " filters";
      });
      EXPECT_EQ(next, expected.size());
      EXPECT_EQ(record.dropped(), 0u);
    }
  }
}

TEST_F(Stream, EveryStageOnItsOwnThreadGivesTheSameToo) {
  options_.filters.clear();
  for (const StageName& stage : stage_names)
    options_.filters.push_back({std::string(stage.key), stage.id, 1});
  const auto expected = serial_predictions({});
  std::size_t next = 0;
  run({}, [&](Passage& passage) { EXPECT_EQ(bytes_of(passage.workspace->result), expected[next++]); });
  EXPECT_EQ(next, expected.size());
}

TEST_F(Stream, SeveralThreadsInsideAFrameGiveTheSameToo) {
#if defined(__SANITIZE_THREAD__)
  GTEST_SKIP()
      << "TBB is not built for ThreadSanitizer, which cannot see how its threads wait for each other";
#endif
  threads_in_frame_ = 2;
  const auto expected = serial_predictions({});
  std::size_t next = 0;
  run({}, [&](Passage& passage) { EXPECT_EQ(bytes_of(passage.workspace->result), expected[next++]); });
  EXPECT_EQ(next, expected.size());
}

TEST_F(Stream, TheRecordHoldsEveryFrameWithItsTimes) {
  const StreamRecord record = run({});
  ASSERT_EQ(record.samples.size(), 20u);
  EXPECT_EQ(record.offered, 20u);
  EXPECT_EQ(record.due, 20u);
  EXPECT_EQ(record.first_counted(), 2u);
  EXPECT_GT(record.throughput_hz(), 0);
  EXPECT_GT(record.memory.after_warmup_mb, 0);
  EXPECT_FALSE(record.interrupted);
  for (const StreamSample& sample : record.samples) {
    double work_ms = 0;
    for (const FilterTimes& filter : sample.filters) work_ms += filter.work_ms;
    EXPECT_LE(sample.stages.total_ms, work_ms);
    EXPECT_LE(work_ms, sample.pass_ms);
    EXPECT_LE(sample.pass_ms, sample.latency_ms);
    EXPECT_GT(sample.surfaces, 0);
  }
}

TEST_F(Stream, AFrameThatCannotBeProcessedStopsItWithItsError) {
  depth_m_[5](3, 4) = -1;
  options_.frames = 0;
  options_.seconds = 1000;
  expect_error(ErrorKind::data, "depth", [&] { run({}); });
}

TEST_F(Stream, ASinkThatThrowsStopsItWithItsError) {
  options_.frames = 1000000;
  expect_error(ErrorKind::internal, "disk is full", [&] {
    run({}, [](Passage& passage) {
      if (passage.number == 3) throw Error(ErrorKind::internal, "disk is full");
    });
  });
}

TEST_F(Stream, ASignalEndsItAndFramesInsideAreFinished) {
  options_.frames = 1000000;
  const StreamRecord record = run({}, [&](Passage& passage) {
    if (passage.number == 4) stop_signal_ = 2;
  });
  EXPECT_TRUE(record.interrupted);
  EXPECT_EQ(record.samples.size(), record.offered);
  EXPECT_LT(record.offered, 100u);
}

TEST_F(Stream, ASensorThatIsTooFastLosesFramesWhereTheyAreDroppedAndIsHeldUpWhereTheyWait) {
  options_.pace = StreamPace::fixed;
  options_.rate_hz = 5000;
  options_.frames = 100;
  const StreamRecord held_up = run({});
  EXPECT_EQ(held_up.samples.size(), 100u);
  EXPECT_GT(held_up.late, 0u);
  EXPECT_EQ(held_up.dropped(), 0u);
  options_.policy = QueuePolicy::drop;
  const StreamRecord lossy = run({});
  EXPECT_GT(lossy.dropped(), 0u);
  EXPECT_EQ(lossy.samples.size() + lossy.dropped(), 100u);
}

TEST_F(Stream, FramesThatFoundNoRoomInTimeWereDueAllTheSame) {
  options_.pace = StreamPace::fixed;
  options_.rate_hz = 100000;
  options_.frames = 0;
  options_.seconds = 0.05;
  const StreamRecord record = run({});
  EXPECT_EQ(record.due, 5000u);
  EXPECT_LT(record.offered, record.due);
}

TEST_F(Stream, TheRecordedPaceIsKept) {
  options_.pace = StreamPace::recorded;
  options_.frames = 10;
  const StreamRecord record = run({});
  ASSERT_EQ(record.samples.size(), 10u);
  EXPECT_GE(record.samples.back().done_s, 9.0 / 30);
}

}  // namespace
}  // namespace facet
