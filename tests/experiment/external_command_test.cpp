#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "experiment/facet_process.hpp"
#include "experiment/small_frames.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// Runs an experiment with a program beside the default method, over two built-in scenes.
class ExternalCommand : public ::testing::Test {
 protected:
  ProcessResult run(const std::string& params, const std::vector<std::string>& options = {}) {
    facet_.write(
        "exp.yaml",
        "schema: 1\ndatasets: [{name: synthetic, reader: synthetic}]\nmethods:\n  - {name: default}\n"
        "  - name: theirs\n    kind: external\n    params:\n" +
            params + "timing: {repeats: 0}\noutputs: {overlays: false}\n");
    std::vector<std::string> arguments{"run", "exp.yaml", "-o", "out", "--limit", "2"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return facet_.run(arguments);
  }
  fs::path run_directory() const { return facet_.latest("out", "exp"); }
  nlohmann::json result_of(const std::string& method) const {
    const auto summary = nlohmann::json::parse(file_text(run_directory() / "metrics/summary.json"));
    for (const auto& result : summary.at("results"))
      if (result.at("method") == method) return result;
    return {};
  }

  FacetProcess facet_;
};

TEST_F(ExternalCommand, AFailingProgramCountsAsZeroAndIsListedAndLosesNothingElse) {
  const ProcessResult result =
      run("      command: \"echo out of luck >&2; false {depth} {out}\"\n", {"-j", "2"});
  EXPECT_EQ(result.exit_code, 5) << result.err;
  EXPECT_THAT(result.out, HasSubstr("the program exited with status 1: out of luck"));
  const auto theirs = result_of("theirs"), ours = result_of("default");
  EXPECT_EQ(theirs.at("counts").at("n_method_failed"), 2);
  const auto recall = [](const nlohmann::json& r) { return r.at("micro").at("surface_recall_0.5"); };
  EXPECT_EQ(recall(theirs).at("hit"), 0);
  EXPECT_EQ(recall(theirs).at("n"), recall(ours).at("n"));
  EXPECT_GT(recall(ours).at("hit"), 0);
  std::size_t logs = 0;
  for (const auto& entry : fs::directory_iterator(run_directory() / "programs/theirs/synthetic"))
    logs += entry.path().string().ends_with(".stderr.txt");
  EXPECT_EQ(logs, 2u);
}

TEST_F(ExternalCommand, PredictionsOfARunCopiedByAProgramScoreAsThatRun) {
  run("      command: \"false {depth} {out}\"\n");
  fs::copy(run_directory() / "predictions/default/synthetic", facet_.folder() / "theirs");
  for (const char* per : {"frame", "batch"}) {
    // Per frame {out} ends in the frame's name, in a batch it is the folder.
    const std::string copy = per == std::string("frame")
                                 ? "n=$(basename {depth} .png); cp theirs/$n.labels.png {out}.labels.png; cp "
                                   "theirs/$n.edges.png {out}.edges.png; cp theirs/$n.surfaces.json "
                                   "{out}.surfaces.json"
                                 : "ls {depth} >&2; cp theirs/* {out}";
    const ProcessResult result = run("      command: '" + copy + "'\n      per: " + per + "\n", {"-j", "2"});
    EXPECT_EQ(result.exit_code, 0) << result.out;
    EXPECT_EQ(result_of("theirs").at("micro"), result_of("default").at("micro"));
    EXPECT_THAT(file_text(run_directory() / "timing/io.csv"), HasSubstr("theirs,program,"));
    EXPECT_THAT(file_text(run_directory() / "report/report.md"), HasSubstr("program of theirs"));
  }
}

TEST_F(ExternalCommand, AWrongEntryIsAConfigurationErrorBeforeAnythingRuns) {
  const ProcessResult result =
      run("      command: \"run {depth} {out}\"\n      timeout_s: 0\n      shel: no\n");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("timeout_s"));
  EXPECT_THAT(result.err, HasSubstr("shel"));
  EXPECT_EQ(run("      command: \"run {depth}\"\n").exit_code, 3);
  EXPECT_FALSE(fs::exists(facet_.folder() / "out"));
}

TEST_F(ExternalCommand, TheExampleInPythonFindsSurfaces) {
  if (std::system("/usr/bin/python3 -c 'import cv2, numpy' 2> /dev/null") != 0)
    GTEST_SKIP() << "/usr/bin/python3 has no cv2 or no numpy (python3-opencv)";
  const ProcessResult result = run("      command: \"/usr/bin/python3 " FACET_EXAMPLES
                                   "/components.py {depth} {intrinsics} {out}\"\n");
  EXPECT_EQ(result.exit_code, 0) << result.out;
  EXPECT_GT(result_of("theirs").at("micro").at("surface_recall_0.5").at("value"), 0.3);
}

}  // namespace
}  // namespace facet
