#include "method/external.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;

Frame frame_of(const std::string& id) {
  Frame frame;
  frame.id = id;
  frame.depth_m = Image<float>(Size{8, 6}, 0.5f);
  frame.depth_m(2, 1) = 0;
  frame.color = cv::Mat(6, 8, CV_8UC3, cv::Scalar(1, 2, 3));
  frame.camera = {10, 11, 3.5f, 2.5f};
  return frame;
}

/// Frames that are all alike.
class AlikeFrames final : public Dataset {
 public:
  const std::string& name() const override { return name_; }
  std::string description() const override { return ""; }
  Sensor sensor() const override { return Sensor::kinect_v1; }
  std::size_t size() const override { return 3; }
  std::string frame_id(std::size_t i) const override { return "f/" + std::to_string(i); }
  Frame load(std::size_t i) const override { return frame_of(frame_id(i)); }
  std::optional<FrameAnnotation> annotation(std::size_t, const Frame&) const override { return {}; }

 private:
  std::string name_ = "alike";
};

class External : public ::testing::Test {
 protected:
  External() {
    spec_.name = "theirs";
    spec_.kind = "external";
    cv::imwrite((folder_.path() / "good.png").string(), cv::Mat(6, 8, CV_8U, cv::Scalar(4)));
    cv::imwrite((folder_.path() / "small.png").string(), cv::Mat(3, 4, CV_8U, cv::Scalar(4)));
    spec_.folder = folder_.path();
    context_.folder = folder_.path() / "kept";
  }
  Prediction process(const std::string& id = "f1") {
    Prediction prediction;
    make_method(spec_, context_)->process(frame_of(id), prediction, times_);
    return prediction;
  }
  void expect_failure(const std::string& command, const std::string& reason) {
    spec_.external.command = command;
    expect_error(ErrorKind::data, reason, [&] { process(); });
  }

  TemporaryFolder folder_;
  MethodSpec spec_;
  MethodContext context_;
  StageTimes times_;
};

TEST_F(External, AProgramIsGivenTheFrameAndItsLabelsAreTaken) {
  spec_.external.command =
      "cp {depth} d.png; cp {color} c.png; cp {intrinsics} k.json; cp good.png {out}.labels.png";
  spec_.external.depth_unit_mm = 0.1f;
  EXPECT_EQ(process().labels(7, 5), 4);
  EXPECT_GT(times_.total_ms, 0);
  const cv::Mat depth = cv::imread((folder_.path() / "d.png").string(), cv::IMREAD_UNCHANGED);
  EXPECT_EQ(depth.at<std::uint16_t>(0, 0), 5000);
  EXPECT_EQ(depth.at<std::uint16_t>(1, 2), 0);
  EXPECT_EQ(cv::imread((folder_.path() / "c.png").string()).at<cv::Vec3b>(0, 0), cv::Vec3b(1, 2, 3));
  const auto camera = nlohmann::json::parse(std::ifstream(folder_.path() / "k.json"));
  EXPECT_EQ(camera.at("fy"), 11);
  EXPECT_EQ(camera.at("width"), 8);
  EXPECT_NEAR(camera.at("depth_unit_m").get<double>(), 1e-4, 1e-10);
}

TEST_F(External, AProgramThatFailsHasAReasonAndItsStandardErrorIsKept) {
  expect_failure("cp good.png {out}.labels.png; echo {depth} >/dev/null; echo no luck >&2; exit 1",
                 "the program exited with status 1: no luck");
  std::ifstream kept(context_.folder / "f1.stderr.txt");
  std::string line;
  std::getline(kept, line);
  EXPECT_EQ(line, "no luck");
}

TEST_F(External, AHangingProgramIsStopped) {
  spec_.external.timeout_s = 0.2f;
  expect_failure("sleep 60; : {depth} {out}", "killed after 0.2 s");
}

TEST_F(External, NothingABrokenImageAndAnotherSizeAreFailures) {
  expect_failure(": {depth} {out}", "the program wrote no f1.labels.png");
  expect_failure("cp small.png {out}.labels.png; : {depth}", "f1.labels.png: is 4x3 but the frame is 8x6");
  expect_failure("head -c 40 good.png > {out}.labels.png; : {depth}", "f1.labels.png: ");
  EXPECT_THROW(process(), Error);
}

TEST_F(External, WhatAnEarlierAttemptWroteIsNotTakenForAnAnswer) {
  spec_.external.command = "cp good.png {out}.labels.png; : {depth}";
  EXPECT_EQ(process().labels(0, 0), 4);
  expect_failure(": {depth} {out}", "wrote no f1.labels.png");
}

TEST_F(External, DepthThatDoesNotFitItsUnitIsAnError) {
  spec_.external.depth_unit_mm = 0.01f;
  Frame frame = frame_of("far");
  frame.depth_m.fill(0.7f);
  spec_.external.command = ": {depth} {out}";
  Prediction prediction;
  expect_error(ErrorKind::data, "depth_unit_mm",
               [&] { make_method(spec_, context_)->process(frame, prediction, times_); });
}

TEST_F(External, ACommandNeedsItsPlaceholdersAndAFolder) {
  spec_.external.command = "run {depth}";
  expect_error(ErrorKind::config, "has no {out}", [&] { make_method(spec_, {}); });
  spec_.external.command = "run {depth} {out}";
  spec_.folder = "nowhere";
  expect_error(ErrorKind::data, "nowhere: folder is missing", [&] { make_method(spec_, {}); });
}

TEST_F(External, ABatchRunsOnceForAllFramesAndWhatItWroteBeforeItFailedCounts) {
  spec_.external.per = ProgramCall::batch;
  spec_.external.command =
      "echo run >> calls; for f in {depth}/*; do n=$(basename $f .png); [ $n = f%2F2 ] && exit 9; "
      "cp good.png {out}/$n.labels.png; done";
  run_external_batch(spec_, {AlikeFrames(), {0, 1, 2}}, context_);
  EXPECT_EQ(process("f/0").labels(0, 0), 4);
  EXPECT_GT(times_.total_ms, 0);
  EXPECT_EQ(process("f/1").labels(0, 0), 4);
  expect_error(ErrorKind::data, "exited with status 9", [&] { process("f/2"); });
  EXPECT_EQ(fs::file_size(folder_.path() / "calls"), 4u);
}

TEST_F(External, AFinishedBatchIsNotRunAgain) {
  spec_.external.per = ProgramCall::batch;
  spec_.external.command = "echo run >> calls; : {depth} {out}";
  const AlikeFrames frames;
  run_external_batch(spec_, {frames, {0, 1}}, context_);
  run_external_batch(spec_, {frames, {0, 1}}, context_);
  EXPECT_EQ(fs::file_size(folder_.path() / "calls"), 4u);
  expect_error(ErrorKind::data, "wrote no f%2F1.labels.png", [&] { process("f/1"); });
}

TEST_F(External, WithoutABatchAFrameIsABatchOfItsOwn) {
  spec_.external.per = ProgramCall::batch;
  spec_.external.command = "for f in {depth}/*; do cp good.png {out}/$(basename $f .png).labels.png; done";
  context_.folder.clear();
  EXPECT_EQ(process("f/1").labels(0, 0), 4);
}

}  // namespace
}  // namespace facet
