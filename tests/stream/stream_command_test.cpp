#include <chrono>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <thread>

#include "experiment/facet_process.hpp"
#include "experiment/small_frames.hpp"

namespace facet {
namespace {

using ::testing::HasSubstr;

class StreamCommand : public ::testing::Test {
 protected:
  StreamCommand() {
    write_small_frames(facet.folder() / "frames", {"a", "b", "c"});
    facet.write("exp.yaml",
                "schema: 1\n" + small_dataset + "methods: [{name: default}]\nstream: {warmup: 5}\n");
  }
  nlohmann::json result() const {
    return nlohmann::json::parse(file_text(facet.latest("results", "exp") / "stream.json")).at(0);
  }
  nlohmann::json manifest() const {
    return nlohmann::json::parse(file_text(facet.latest("results", "exp") / "manifest.json"));
  }
  FacetProcess facet;
};

TEST_F(StreamCommand, OffersTheFramesInTurnAndLeavesARunDirectory) {
  const auto run = facet.run({"stream", "exp.yaml", "--rate", "fastest", "--frames", "100"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("frames/s processed"));
  EXPECT_EQ(result().at("processed"), 100);
  EXPECT_EQ(result().at("frames_in_memory"), 3);
  EXPECT_EQ(result().at("end_to_end").at("frames"), 95);
  EXPECT_EQ(manifest().at("status"), "complete");
  const auto directory = facet.latest("results", "exp");
  EXPECT_THAT(file_text(directory / "report/report.html"), HasSubstr("default on small"));
  EXPECT_THAT(file_text(directory / "timing/stream.csv"), HasSubstr("small,default,99,"));
  EXPECT_THAT(file_text(directory / "dataset.lock.json"), HasSubstr("a.depth.png"));
}

TEST_F(StreamCommand, ItsReportCanBeRenderedAgain) {
  ASSERT_EQ(facet.run({"stream", "exp.yaml", "--rate", "fastest", "--frames", "20", "-q"}).exit_code, 0);
  const auto directory = facet.latest("results", "exp");
  const std::string page = file_text(directory / "report/report.md");
  const auto run = facet.run({"report", directory.string(), "--format", "md,tex,csv"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(file_text(directory / "report/report.md"), page);
  EXPECT_THAT(file_text(directory / "report/tables.tex"), HasSubstr("preprocessing"));
  EXPECT_THAT(file_text(directory / "report/report.csv"), HasSubstr("frames per second"));
}

TEST_F(StreamCommand, SaysPlainlyWhereARateIsNotSustained) {
  const auto run =
      facet.run({"stream", "exp.yaml", "--rate", "100000", "--frames", "300", "--policy", "drop", "-q"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("NOT sustained"));
  EXPECT_EQ(result().at("sustained"), false);
  EXPECT_GT(result().at("dropped"), 0);
}

TEST_F(StreamCommand, AnInterruptedStreamEndsCleanlyAndKeepsWhatWasMeasured) {
  const pid_t child = facet.start({"stream", "exp.yaml", "--rate", "100", "--seconds", "1000"});
  for (int i = 0; i < 2000 && !std::filesystem::exists(facet.folder() / "results/exp/latest"); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  ::kill(child, SIGINT);
  const auto run = facet.wait(child);
  EXPECT_EQ(run.exit_code, 130) << run.err;
  EXPECT_EQ(manifest().at("status"), "partial");
}

TEST_F(StreamCommand, AFilterThatIsWrongIsNamedWithItsPlace) {
  facet.write("bad.yaml",
              "schema: 1\n" + small_dataset +
                  "stream:\n  filters: [{name: a, until: winer}, {name: b, until: objects, thread: 2}]\n");
  const auto run = facet.run({"stream", "bad.yaml"});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.err, HasSubstr("stream.filters[0].until: value winer"));
  EXPECT_THAT(run.err, HasSubstr("did you mean \"wiener\"?"));
  EXPECT_THAT(run.err, HasSubstr("stream.filters[1].thread"));
  facet.write("order.yaml", "schema: 1\nstream:\n  filters: [{name: a, until: pose}]\n");
  EXPECT_THAT(facet.run({"stream", "order.yaml"}).err,
              HasSubstr("stream.filters: the last filter must run until"));
}

TEST_F(StreamCommand, NothingButWarmUpIsNotMeasured) {
  const auto run = facet.run({"stream", "exp.yaml"});
  EXPECT_EQ(run.exit_code, 6);
  EXPECT_THAT(run.err, HasSubstr("3 frames are offered and the first 5 are warm-up"));
}

TEST_F(StreamCommand, ARateThatIsNoneIsAMistakeOfTheCommandLine) {
  EXPECT_EQ(facet.run({"stream", "exp.yaml", "--rate", "often"}).exit_code, 2);
}

TEST_F(StreamCommand, OnlyPipelinesCanBeStreamed) {
  facet.write("stored.yaml",
              "schema: 1\n" + small_dataset + "methods: [{name: p, kind: predictions, folder: x}]\n");
  const auto run = facet.run({"stream", "stored.yaml", "--frames", "50"});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_THAT(run.err, HasSubstr("methods.p: kind predictions cannot be streamed"));
}

}  // namespace
}  // namespace facet
