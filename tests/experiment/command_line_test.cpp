#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/facet_process.hpp"
#include "experiment/small_frames.hpp"

namespace facet {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::Not;

class CommandLine : public ::testing::Test {
 protected:
  CommandLine() {
    write_small_frames(facet.folder() / "frames", {"f1", "f2", "f3"});
    facet.write("exp.yaml", small_experiment);
  }
  void truncate_frame(const std::string& id) const {
    const auto file = facet.folder() / "frames" / (id + ".depth.png");
    std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  }
  FacetProcess facet;
};

TEST_F(CommandLine, ARunOverWholeFramesExitsZeroAndPrintsTimesSurfacesAndPaths) {
  const auto result = facet.run({"run", "exp.yaml", "-o", "out"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("Morphology"));
  EXPECT_THAT(result.out, HasSubstr("paper, GTX 1070, other data"));
  EXPECT_THAT(result.out, HasSubstr("Surfaces found on small"));
  EXPECT_THAT(result.out, HasSubstr("Not scored: no frame has truth."));
  EXPECT_THAT(result.out, HasSubstr("run directory: out/exp/"));
  EXPECT_THAT(result.err, HasSubstr("frames: 6 of 6"));
}

TEST_F(CommandLine, EveryParseErrorExitsTwo) {
  const std::vector<std::vector<std::string>> wrong{{},
                                                    {"fly"},
                                                    {"run"},
                                                    {"run", "exp.yaml", "--nonsense"},
                                                    {"run", "exp.yaml", "-j", "0"},
                                                    {"list", "x"},
                                                    {"run", "exp.yaml", "--limit", "0"},
                                                    {"run", "exp.yaml", "--filter", "("},
                                                    {"run", "exp.yaml", "--set", "seed"}};
  for (const auto& arguments : wrong) {
    const auto result = facet.run(arguments);
    EXPECT_EQ(result.exit_code, 2) << ::testing::PrintToString(arguments) << result.err;
    EXPECT_NE(result.err, "");
    EXPECT_EQ(result.out, "");
  }
}

TEST_F(CommandLine, HelpAndVersionExitZero) {
  EXPECT_EQ(facet.run({"--help"}).exit_code, 0);
  const auto version = facet.run({"--version"});
  EXPECT_EQ(version.exit_code, 0);
  for (const std::string part : {"commit ", "compiler ", "flags ", "cuda "})
    EXPECT_THAT(version.out, HasSubstr(part));
}

TEST_F(CommandLine, AConfigurationErrorExitsThreeWithItsPlace) {
  facet.write("bad.yaml", "schema: 1\ntiming: {repeat: 5}\n");
  const auto result = facet.run({"run", "bad.yaml"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("bad.yaml:2:10: timing.repeat"));
}

TEST_F(CommandLine, AStudyIsForItsOwnCommand) {
  facet.write("a.yaml", small_experiment + "ablation: {switches: [fill]}\n");
  facet.write("s.yaml", small_experiment + "sweep: {wiener.window_px: [3]}\n");
  EXPECT_EQ(facet.run({"run", "a.yaml"}).exit_code, 3);
  EXPECT_THAT(facet.run({"run", "a.yaml"}).err, HasSubstr("`ablation`"));
  EXPECT_EQ(facet.run({"run", "s.yaml"}).exit_code, 3);
  EXPECT_EQ(facet.run({"show-config", "a.yaml"}).exit_code, 0);
}

TEST_F(CommandLine, ATruncatedFrameIsCountedTheRestFinishesAndTheExitIsFive) {
  truncate_frame("f2");
  const auto result = facet.run({"run", "exp.yaml", "-o", "out"});
  EXPECT_EQ(result.exit_code, 5);
  EXPECT_THAT(result.out, HasSubstr("4 of 6 frames processed, 2 failed"));
  EXPECT_THAT(result.out, HasSubstr("small/f2"));
  EXPECT_THAT(result.out, HasSubstr("f2.depth.png"));
  const auto run = facet.latest("out", "exp");
  EXPECT_TRUE(std::filesystem::exists(run / "predictions/a/small/f3.labels.png"));
  EXPECT_FALSE(std::filesystem::exists(run / "predictions/a/small/f2.labels.png"));
  EXPECT_THAT(file_text(run / "manifest.json"), HasSubstr("\"status\": \"failed\""));
}

TEST_F(CommandLine, ForgivenFailuresExitZeroAndFailFastExitsFour) {
  truncate_frame("f1");
  EXPECT_EQ(facet.run({"run", "exp.yaml", "-o", "out", "--max-failures", "2"}).exit_code, 0);
  EXPECT_EQ(facet.run({"run", "exp.yaml", "-o", "out", "--max-failures", "1"}).exit_code, 5);
  EXPECT_EQ(facet.run({"run", "exp.yaml", "-o", "out", "--fail-fast"}).exit_code, 4);
}

TEST_F(CommandLine, NothingEvaluatedIsNeverZero) {
  for (const std::string id : {"f1", "f2", "f3"}) truncate_frame(id);
  EXPECT_EQ(facet.run({"run", "exp.yaml", "-o", "out", "--max-failures", "100"}).exit_code, 6);
}

TEST_F(CommandLine, AMissingOrEmptyFolderExitsFour) {
  std::filesystem::remove_all(facet.folder() / "frames");
  EXPECT_EQ(facet.run({"run", "exp.yaml", "-o", "out"}).exit_code, 4);
  std::filesystem::create_directories(facet.folder() / "frames");
  const auto empty = facet.run({"run", "exp.yaml", "-o", "out"});
  EXPECT_EQ(empty.exit_code, 4);
  EXPECT_THAT(empty.err, HasSubstr("frames"));
}

TEST_F(CommandLine, AMissingDataRootExitsFourAndSaysHowToGiveIt) {
  facet.write("osd.yaml", "schema: 1\ndatasets: [osd]\n");
  const auto result = facet.run({"run", "osd.yaml"});
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_THAT(result.err, HasSubstr("--data-root"));
}

TEST_F(CommandLine, AFilterThatLeavesNothingExitsSix) {
  EXPECT_EQ(facet.run({"run", "exp.yaml", "--filter", "nothing"}).exit_code, 6);
}

TEST_F(CommandLine, FilterAndLimitChooseFrames) {
  EXPECT_THAT(facet.run({"run", "exp.yaml", "--filter", "small/f[23]", "--dry-run"}).out,
              HasSubstr("2 of 3 frames"));
  EXPECT_THAT(facet.run({"run", "exp.yaml", "--filter", "f[23]", "--limit", "1", "--dry-run"}).out,
              HasSubstr("1 of 3 frames"));
}

TEST_F(CommandLine, ADryRunWritesNothing) {
  EXPECT_EQ(facet.run({"run", "exp.yaml", "-o", "out", "--dry-run"}).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(facet.folder() / "out"));
}

/// No device is visible to the program, whatever the machine has.
void hide_devices() {
  ::setenv("CUDA_VISIBLE_DEVICES", "", 1);
}

TEST_F(CommandLine, CudaThatIsNotThereExitsSixAndSaysWhy) {
  const auto result = facet.run({"run", "exp.yaml", "--backend", "cuda", "-o", "out"}, hide_devices);
  EXPECT_EQ(result.exit_code, 6);
  EXPECT_THAT(result.err, HasSubstr("--backend cuda: "));
  EXPECT_THAT(result.err,
              AnyOf(HasSubstr("without CUDA"), HasSubstr("no NVIDIA driver"), HasSubstr("no CUDA device")));
  EXPECT_FALSE(std::filesystem::exists(facet.folder() / "out"));
}

TEST_F(CommandLine, WithoutADeviceAutoRunsOnTheCpuAndTheRecordSaysSo) {
  const auto result = facet.run({"run", "exp.yaml", "--backend", "auto", "-o", "out"}, hide_devices);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("back end cpu: "));
  const std::filesystem::path run = facet.latest("out", "exp");
  EXPECT_THAT(file_text(run / "manifest.json"), HasSubstr("\"backend\": \"cpu\""));
  EXPECT_THAT(file_text(run / "env.json"), HasSubstr("\"backend\": \"cpu: "));
}

TEST_F(CommandLine, MethodsThatAreNoPipelineRunOnTheCpuAndTheRecordSaysSo) {
  const auto result = facet.run(
      {"run", "exp.yaml", "-o", "out", "--set", "methods=[{name: pairs, kind: edge_pairs}]"}, hide_devices);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("back end cpu: no method is a pipeline"));
}

TEST_F(CommandLine, OutputBelowARegularFileIsAClearError) {
  facet.write("file", "x");
  const auto result = facet.run({"run", "exp.yaml", "-o", "file/out"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("file/out"));
}

TEST_F(CommandLine, AFullDiskIsAClearErrorAndNotADeadProcess) {
  const auto result = facet.run({"run", "exp.yaml", "-o", "out"}, [] {
    const rlimit limit{512, 512};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  });
  EXPECT_EQ(result.exit_code, 70);
  EXPECT_THAT(file_text(facet.folder() / "stderr"), HasSubstr("cannot be written"));
}

TEST_F(CommandLine, FramesWithOddNamesGetSafeFilesAndReadableRows) {
  const auto first = facet.folder() / "frames/f1.depth.png";
  std::filesystem::rename(first, facet.folder() / "frames/ö \"1\",%.depth.png");
  const auto result = facet.run({"run", "exp.yaml", "-o", "out"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const auto run = facet.latest("out", "exp");
  EXPECT_TRUE(std::filesystem::exists(run / "predictions/a/small/%C3%B6%20%221%22%2C%25.labels.png"));
  EXPECT_THAT(file_text(run / "frames.jsonl"), HasSubstr("\"frame\":\"ö \\\"1\\\",%\""));
  EXPECT_EQ(facet.run({"report", run.string()}).exit_code, 0);
}

TEST_F(CommandLine, AFileNameThatIsNotUtf8ExitsFourAndIsShown) {
  std::filesystem::rename(facet.folder() / "frames/f1.depth.png", facet.folder() / "frames/f\xff.depth.png");
  const auto result = facet.run({"run", "exp.yaml", "-o", "out"});
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_THAT(result.err, HasSubstr("f%FF.depth.png"));
}

TEST_F(CommandLine, ReportRendersAStoredRunAgain) {
  ASSERT_EQ(facet.run({"run", "exp.yaml", "-o", "out"}).exit_code, 0);
  const auto run = facet.latest("out", "exp");
  const std::string before = file_text(run / "report/report.md");
  std::filesystem::remove_all(run / "report");
  EXPECT_EQ(facet.run({"report", run.string()}).exit_code, 0);
  EXPECT_EQ(file_text(run / "report/report.md"), before);
  EXPECT_EQ(facet.run({"report", facet.folder().string()}).exit_code, 4);
}

TEST_F(CommandLine, ListsAndDoctorAnswerOnStdout) {
  EXPECT_THAT(facet.run({"list", "datasets"}).out, HasSubstr("synthetic"));
  EXPECT_THAT(facet.run({"list", "methods"}).out, HasSubstr("pipeline"));
  EXPECT_THAT(facet.run({"list", "methods"}).out, HasSubstr("timeout_s = 60"));
  EXPECT_THAT(facet.run({"list", "stages"}).out, HasSubstr("crease_canny"));
  EXPECT_THAT(facet.run({"list", "metrics"}).out, HasSubstr("surfaces"));
  EXPECT_THAT(facet.run({"doctor"}).out, AllOf(HasSubstr("\"cpu\""), HasSubstr("\"backend\"")));
  EXPECT_THAT(facet.run({"dataset", "list"}).out, HasSubstr("osd"));
  EXPECT_THAT(facet.run({"dataset", "info", "synthetic"}).out, HasSubstr("frames  6"));
}

TEST_F(CommandLine, VerifyExitsFourWhereAFileIsBroken) {
  facet.write("frames/dataset.yaml",
              "depth: \"{id}.depth.png\"\ndepth_unit_m: 0.001\n"
              "intrinsics: [60, 60, 31.5, 23.5]\n");
  EXPECT_EQ(facet.run({"dataset", "verify", "frames"}).exit_code, 0)
      << facet.run({"dataset", "verify", "frames"}).err;
  truncate_frame("f1");
  const auto broken = facet.run({"dataset", "verify", "frames"});
  EXPECT_EQ(broken.exit_code, 4);
  EXPECT_THAT(broken.out, HasSubstr("f1"));
  EXPECT_EQ(facet.run({"dataset", "info", "nowhere"}).exit_code, 4);
}

}  // namespace
}  // namespace facet
