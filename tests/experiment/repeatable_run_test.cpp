#include <chrono>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <thread>

#include "experiment/facet_process.hpp"
#include "experiment/small_frames.hpp"

namespace facet {
namespace {

using ::testing::HasSubstr;

/// The files that must not differ: predictions, metrics, rows.
std::map<std::string, std::string> lasting_files(const std::filesystem::path& run) {
  auto files = contents_below(run / "predictions");
  files.merge(contents_below(run / "metrics"));
  files["frames.jsonl"] = file_text(run / "frames.jsonl");
  files["dataset.lock.json"] = file_text(run / "dataset.lock.json");
  return files;
}

std::vector<std::string> many_ids(int count) {
  std::vector<std::string> ids;
  for (int i = 0; i < count; ++i) ids.push_back(std::string("f").append(std::to_string(i)));
  return ids;
}

class RepeatableRun : public ::testing::Test {
 protected:
  RepeatableRun() {
    write_small_frames(facet.folder() / "frames", many_ids(30));
    facet.write("exp.yaml", small_experiment);
  }
  std::filesystem::path whole_run(const std::string& out, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"run", "exp.yaml", "-o", out, "--set", "timing.repeats=0"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto result = facet.run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return facet.latest(out, "exp");
  }
  /// Starts a run and sends `signal` once some frames are done.
  ProcessResult interrupted_run(const std::string& out, int signal) {
    const pid_t child = facet.start({"run", "exp.yaml", "-o", out, "--set", "timing.repeats=0"});
    const auto rows = facet.folder() / out / "exp/latest/frames.jsonl";
    for (int i = 0; i < 2000 && (!std::filesystem::exists(rows) || std::filesystem::file_size(rows) < 1500);
         ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    ::kill(child, signal);
    return facet.wait(child);
  }
  FacetProcess facet;
};

TEST_F(RepeatableRun, OneJobAndTwoJobsGiveTheSameBytes) {
  EXPECT_EQ(lasting_files(whole_run("one", {"-j", "1"})), lasting_files(whole_run("two", {"-j", "2"})));
}

TEST_F(RepeatableRun, KilledAndResumedGivesTheSameBytes) {
  const auto whole = lasting_files(whole_run("whole"));
  const auto killed = interrupted_run("killed", SIGKILL);
  ASSERT_EQ(killed.exit_code, 1000 + SIGKILL) << "the run ended before it could be killed";
  const auto started = facet.latest("killed", "exp");
  // As if the kill had come in the middle of a line.
  std::ofstream(started / "frames.jsonl", std::ios::app) << "{\"dataset\":\"sm";
  EXPECT_THAT(file_text(started / "manifest.json"), HasSubstr("\"status\": \"running\""));
  EXPECT_EQ(lasting_files(whole_run("killed", {"--resume"})), whole);
  EXPECT_EQ(facet.latest("killed", "exp"), started);
  EXPECT_THAT(file_text(started / "log.jsonl"), HasSubstr("\"event\":\"kept\""));
}

TEST_F(RepeatableRun, InterruptedExitsByTheSignalAndCanBeResumed) {
  const auto whole = lasting_files(whole_run("whole"));
  const auto interrupted = interrupted_run("stopped", SIGINT);
  EXPECT_EQ(interrupted.exit_code, 130);
  EXPECT_THAT(interrupted.err, HasSubstr("--resume"));
  const auto started = facet.latest("stopped", "exp");
  EXPECT_THAT(file_text(started / "manifest.json"), HasSubstr("\"status\": \"partial\""));
  EXPECT_EQ(lasting_files(whole_run("stopped", {"--resume"})), whole);
  EXPECT_EQ(facet.latest("stopped", "exp"), started);
}

TEST_F(RepeatableRun, AResumedRunDoesAFrameAgainWhoseInputChanged) {
  const auto run = whole_run("out");
  const std::string before = file_text(run / "frames.jsonl");
  write_small_frames(facet.folder() / "frames", {"other", "f0"});  // f0 gets the square of another frame
  std::filesystem::remove(facet.folder() / "frames/other.depth.png");
  EXPECT_EQ(whole_run("out", {"--resume"}), run);
  EXPECT_NE(file_text(run / "frames.jsonl"), before);
}

TEST_F(RepeatableRun, AResumedRunTriesFailedFramesAgain) {
  const auto frame = facet.folder() / "frames/f7.depth.png";
  const std::string whole_frame = file_text(frame);
  std::filesystem::resize_file(frame, 40);
  EXPECT_EQ(facet.run({"run", "exp.yaml", "-o", "out", "--set", "timing.repeats=0"}).exit_code, 5);
  std::ofstream(frame, std::ios::binary) << whole_frame;
  EXPECT_EQ(lasting_files(whole_run("out", {"--resume"})), lasting_files(whole_run("fresh")));
}

TEST_F(RepeatableRun, ASequenceResumedHalfWayRemembersThePastFrames) {
  facet.write(
      "exp.yaml",
      std::string(small_experiment).replace(small_experiment.find("depth_unit_m"), 0, "sequence: true, "));
  const auto whole = lasting_files(whole_run("whole"));
  const auto run = whole_run("half");
  std::string rows = file_text(run / "frames.jsonl");
  rows.resize(rows.size() / 2);  // as a kill leaves it
  std::ofstream(run / "frames.jsonl", std::ios::trunc) << rows;
  std::filesystem::remove_all(run / "predictions/b");
  EXPECT_EQ(whole_run("half", {"--resume"}), run);
  auto resumed = lasting_files(run);
  EXPECT_EQ(resumed["frames.jsonl"], whole.at("frames.jsonl"));
  EXPECT_EQ(resumed["b/small/f29.labels.png"], whole.at("b/small/f29.labels.png"));
}

TEST_F(RepeatableRun, AnotherConfigurationIsAnotherRun) {
  const auto first = whole_run("out");
  const auto second = whole_run("out", {"--resume", "--set", "seed=2"});
  EXPECT_NE(first, second);
}

}  // namespace
}  // namespace facet
