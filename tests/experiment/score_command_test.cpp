#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "experiment/facet_process.hpp"
#include "experiment/small_frames.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

/// One run of the default method over two built-in scenes, for all tests; and its predictions.
class ScoreCommand : public ::testing::Test {
 protected:
  ScoreCommand() {
    if (facet_ != nullptr) return;
    facet_ = new FacetProcess;
    facet_->write("exp.yaml",
                  "schema: 1\ndatasets: [{name: synthetic, reader: synthetic}]\nmethods: [{name: default}]\n"
                  "timing: {repeats: 0}\noutputs: {overlays: false}\n");
    run_ = new ProcessResult(facet_->run({"run", "exp.yaml", "-o", "out"}));
  }
  static void TearDownTestSuite() {
    delete facet_;
    delete run_;
  }
  static nlohmann::json summary_of(const std::string& experiment) {
    return nlohmann::json::parse(file_text(facet_->latest("out", experiment) / "metrics/summary.json"))
        .at("results")
        .at(0);
  }
  static fs::path predictions() { return facet_->latest("out", "exp") / "predictions/default/synthetic"; }
  /// A copy of the predictions that a test may spoil.
  static fs::path copied_predictions(const std::string& name) {
    const fs::path copy = facet_->folder() / name;
    fs::copy(predictions(), copy);
    return copy;
  }
  static ProcessResult score(const fs::path& folder) {
    return facet_->run({"score", "--pred", folder.string(), "--data", "synthetic", "-o", "out"});
  }
  static fs::path first_labels(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().string().ends_with(".labels.png")) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files.front();
  }

  static FacetProcess* facet_;
  static ProcessResult* run_;
};
FacetProcess* ScoreCommand::facet_ = nullptr;
ProcessResult* ScoreCommand::run_ = nullptr;

TEST_F(ScoreCommand, ARunOverAnnotatedFramesPrintsTheTableOfThePaper) {
  EXPECT_EQ(run_->exit_code, 0) << run_->err;
  EXPECT_THAT(run_->out, HasSubstr("Detected on synthetic"));
  EXPECT_THAT(run_->out, ContainsRegex("Graspable edges, 6 px +[0-9]+/[0-9]+ [0-9.]+ %"));
  EXPECT_THAT(run_->out, HasSubstr("225/229 98.3 %"));
  EXPECT_THAT(run_->out, HasSubstr("Truth of 6 frames: geometry of the built-in scenes."));
  const nlohmann::json result = summary_of("exp");
  EXPECT_EQ(result.at("counts").at("n_scored"), 6);
  EXPECT_GT(result.at("micro").at("surface_recall_0.5").at("value"), 0.5);
  EXPECT_GT(result.at("errors").at("normal_error_deg").at("n"), 0);
}

TEST_F(ScoreCommand, StoredPredictionsScoreAsTheRunThatWroteThem) {
  const ProcessResult result = score(predictions());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(summary_of("score").at("micro"), summary_of("exp").at("micro"));
  EXPECT_THAT(result.out, HasSubstr("Not timed."));
}

TEST_F(ScoreCommand, AFrameWithoutPredictionFailsAndStaysInEveryDenominator) {
  const fs::path folder = copied_predictions("lost");
  fs::remove(first_labels(folder));
  const ProcessResult result = score(folder);
  EXPECT_EQ(result.exit_code, 5);
  EXPECT_THAT(result.out, HasSubstr("labels.png"));
  const nlohmann::json now = summary_of("score"), before = summary_of("exp");
  EXPECT_EQ(now.at("counts").at("n_method_failed"), 1);
  EXPECT_EQ(now.at("counts").at("n_total"), 6);
  const auto recall = [](const nlohmann::json& r) { return r.at("micro").at("surface_recall_0.5"); };
  EXPECT_EQ(recall(now).at("n"), recall(before).at("n"));
  EXPECT_LT(recall(now).at("hit"), recall(before).at("hit"));
}

TEST_F(ScoreCommand, APredictionWithoutAFrameIsNamed) {
  const fs::path folder = copied_predictions("extra");
  fs::copy(first_labels(folder), folder / "other.labels.png");
  EXPECT_THAT(score(folder).out, HasSubstr("prediction without a frame: other"));
}

TEST_F(ScoreCommand, LabelsAloneAreScoredAndTheRestIsNotProvided) {
  const fs::path folder = copied_predictions("labels");
  for (const auto& entry : fs::directory_iterator(folder))
    if (!entry.path().string().ends_with(".labels.png")) fs::remove(entry.path());
  EXPECT_EQ(score(folder).exit_code, 0);
  const nlohmann::json micro = summary_of("score").at("micro");
  EXPECT_EQ(micro.at("surface_recall_0.5"), summary_of("exp").at("micro").at("surface_recall_0.5"));
  EXPECT_TRUE(micro.at("edge_recall_graspable_6px").at("value").is_null());
  EXPECT_EQ(micro.at("edge_recall_graspable_6px").at("reason"), "the predictions have no edges");
  EXPECT_TRUE(micro.at("objects_pose").at("value").is_null());
}

TEST_F(ScoreCommand, LabelImagesOfAnotherSizeOrTypeAreErrorsThatNameFileAndRule) {
  const fs::path folder = copied_predictions("spoiled");
  cv::imwrite(first_labels(folder), cv::Mat(48, 64, CV_16U, cv::Scalar(1)));
  for (const auto& entry : fs::directory_iterator(folder))
    if (!entry.path().string().ends_with(".labels.png")) fs::remove(entry.path());
  const ProcessResult small = score(folder);
  EXPECT_EQ(small.exit_code, 5);
  EXPECT_THAT(small.out, HasSubstr("64"));
  cv::imwrite(first_labels(folder), cv::Mat(480, 640, CV_8UC3, cv::Scalar(1, 2, 3)));
  const ProcessResult coloured = score(folder);
  EXPECT_EQ(coloured.exit_code, 5);
  EXPECT_THAT(coloured.out, HasSubstr("labels.png"));
}

TEST_F(ScoreCommand, AMissingFolderOfPredictionsOrTruthExitsFour) {
  EXPECT_EQ(score("nowhere").exit_code, 4);
  const auto result = facet_->run({"score", "--pred", predictions().string(), "--data", "synthetic", "-o",
                                   "out", "--annotations", "nowhere"});
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_THAT(result.err, HasSubstr("nowhere: folder is missing"));
}

TEST_F(ScoreCommand, ResumedAndParallelRunsScoreTheSame) {
  EXPECT_EQ(facet_->run({"run", "exp.yaml", "-o", "out2", "-j", "2"}).exit_code, 0);
  const auto metrics = [](const std::string& out) {
    return contents_below(facet_->latest(out, "exp") / "metrics");
  };
  EXPECT_EQ(metrics("out"), metrics("out2"));
  fs::path rows = facet_->latest("out2", "exp") / "frames.jsonl";
  const std::string text = file_text(rows);
  fs::resize_file(rows, text.find('\n') + 20);  // killed in the second row
  EXPECT_EQ(facet_->run({"run", "exp.yaml", "-o", "out2", "--resume"}).exit_code, 0);
  EXPECT_EQ(metrics("out"), metrics("out2"));
}

TEST_F(ScoreCommand, TheSelftestOfBuiltInScenesIsPerfect) {
  const ProcessResult result = facet_->run({"selftest", "synthetic"});
  EXPECT_EQ(result.exit_code, 0) << result.out;
  EXPECT_THAT(result.out, HasSubstr("6 of 6 frames have truth, 0 problems"));
  EXPECT_THAT(result.out, Not(HasSubstr("WRONG")));
}

TEST_F(ScoreCommand, TheSelftestOfFramesWithoutTruthMeasuresNothing) {
  write_small_frames(facet_->folder() / "frames", {"f1"});
  facet_->write("frames/dataset.yaml",
                "depth: \"{id}.depth.png\"\ndepth_unit_m: 0.001\nintrinsics: [60, 60, 31.5, 23.5]\n");
  EXPECT_EQ(facet_->run({"selftest", "frames"}).exit_code, 6);
}

TEST_F(ScoreCommand, ABrokenAnnotationIsAFrameThatCouldNotBeReadWithAllItsProblems) {
  write_small_frames(facet_->folder() / "annotated", {"f1", "f2"});
  facet_->write("annotated/dataset.yaml",
                "depth: \"{id}.depth.png\"\ndepth_unit_m: 0.001\nintrinsics: [60, 60, 31.5, 23.5]\n");
  fs::create_directories(facet_->folder() / "annotated/truth");
  facet_->write("annotated/truth/f1.json",
                R"({"version": "5.0", "imageWidth": 64, "imageHeight": 48, "shapes": [
    {"label": "surfac/1", "group_id": 1, "shape_type": "polygon", "points": [[1, 1], [9, 1], [9, 9]], "flags": {}},
    {"label": "edge/1", "group_id": 1, "shape_type": "linestrip", "points": [[1, 1], [99, 1]], "flags": {}}]})");
  facet_->write("broken.yaml",
                "schema: 1\ndatasets: [{name: a, reader: folder, root: annotated}]\ntiming: {repeats: 0}\n");
  const ProcessResult result = facet_->run({"run", "broken.yaml", "-o", "out"});
  EXPECT_EQ(result.exit_code, 5);
  EXPECT_THAT(result.out, HasSubstr("f1.json"));
  const nlohmann::json counts = summary_of("broken").at("counts");
  EXPECT_EQ(counts.at("n_harness_error"), 1);
  EXPECT_EQ(counts.at("n_not_annotated"), 1);
  const ProcessResult test = facet_->run({"selftest", "annotated"});
  EXPECT_EQ(test.exit_code, 1);
  EXPECT_THAT(test.out, HasSubstr("shape 0"));
  EXPECT_THAT(test.out, HasSubstr("shape 1"));
}

}  // namespace
}  // namespace facet
