#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/config_files.hpp"

namespace facet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<std::string> method_names(const Experiment& experiment) {
  std::vector<std::string> names;
  for (const MethodSpec& method : experiment.methods) names.push_back(method.name);
  return names;
}

TEST(ConfigMerge, MapsMergeKeyByKeyAndListsReplace) {
  ConfigFiles files;
  files.write("base.yaml", "schema: 1\nmethods: [{name: a}, {name: b}]\ntiming: {warmup: 7, repeats: 8}\n");
  const auto loaded = load_experiment(
      files.write("exp.yaml", "schema: 1\nextends: base.yaml\nmethods: [{name: c}]\ntiming: {repeats: 9}\n"));
  EXPECT_THAT(method_names(loaded.experiment), ElementsAre("c"));
  EXPECT_EQ(loaded.experiment.timing.warmup, 7);
  EXPECT_EQ(loaded.experiment.timing.repeats, 9);
}

TEST(ConfigMerge, ALaterBaseBeatsAnEarlierOneAndBothBeatTheBuiltInValue) {
  ConfigFiles files;
  files.write("a.yaml", "schema: 1\nseed: 2\ntiming: {warmup: 1}\n");
  files.write("b.yaml", "schema: 1\nseed: 3\n");
  const auto loaded = load_experiment(files.write("exp.yaml", "schema: 1\nextends: [a.yaml, b.yaml]\n"));
  EXPECT_EQ(loaded.experiment.seed, 3);
  EXPECT_EQ(loaded.experiment.timing.warmup, 1);
  EXPECT_EQ(loaded.experiment.timing.repeats, TimingOptions{}.repeats);
}

TEST(ConfigMerge, BaseFilesAreFoundRelativeToTheFileThatNamesThem) {
  ConfigFiles files;
  files.write("deep/modes/m.yaml", "schema: 1\nextends: more/n.yaml\nwiener: {window_px: 3}\n");
  files.write("deep/modes/more/n.yaml", "schema: 1\nwiener.gain: paper\nwiener.window_px: 7\n");
  files.write("deep/base.yaml",
              "schema: 1\nmethods: [{name: m, params: {extends: modes/m.yaml, fill.enabled: false}}]\n");
  const auto loaded = load_experiment(files.write("exp.yaml", "schema: 1\nextends: deep/base.yaml\n"));
  const PipelineParams& params = loaded.experiment.methods.at(0).params;
  EXPECT_EQ(params.wiener.window_px, 3);
  EXPECT_EQ(params.wiener.gain, WienerGain::paper);
  EXPECT_FALSE(params.fill.enabled);
}

TEST(ConfigMerge, CyclesAreRejectedWhereTheyClose) {
  ConfigFiles files;
  files.write("a.yaml", "schema: 1\nextends: exp.yaml\n");
  EXPECT_THAT(files.errors_of("schema: 1\nextends: a.yaml\n"),
              HasSubstr("a.yaml:2:10: extends: value exp.yaml: expected no cycle"));
  EXPECT_THAT(files.errors_of("schema: 1\nextends: exp.yaml\n"), HasSubstr("expected no cycle"));
}

TEST(ConfigMerge, TheSameBaseMayBeReachedTwice) {
  ConfigFiles files;
  files.write("common.yaml", "schema: 1\nseed: 4\n");
  files.write("a.yaml", "schema: 1\nextends: common.yaml\n");
  files.write("b.yaml", "schema: 1\nextends: common.yaml\n");
  EXPECT_EQ(files.errors_of("schema: 1\nextends: [a.yaml, b.yaml]\n"), "");
}

TEST(ConfigMerge, AMissingBaseFileIsNamedWithItsPlace) {
  ConfigFiles files;
  EXPECT_THAT(files.errors_of("schema: 1\nextends: [none.yaml]\n"),
              HasSubstr("exp.yaml:2:11: extends: value none.yaml"));
}

TEST(ConfigMerge, ARelativeRootIsRelativeToTheFileThatNamesIt) {
  ConfigFiles files;
  files.write("sub/base.yaml", "schema: 1\ndatasets: [{name: f, reader: folder, root: data}]\n");
  const auto loaded = load_experiment(files.write("exp.yaml", "schema: 1\nextends: sub/base.yaml\n"));
  EXPECT_EQ(loaded.experiment.datasets.at(0).root, files.path() / "sub" / "data");
}

TEST(ConfigMerge, ADataSetGivenByItsNameLiesBelowTheDataRoot) {
  ConfigFiles files;
  const auto loaded = load_experiment(files.write("exp.yaml", "schema: 1\ndatasets: [osd, synthetic]\n"));
  EXPECT_EQ(loaded.experiment.datasets.at(0).root, "${data_root}/osd");
  EXPECT_EQ(loaded.experiment.datasets.at(1).reader, "synthetic");
}

TEST(ConfigMerge, TheNameOfTheFileIsTheNameOfTheExperiment) {
  ConfigFiles files;
  EXPECT_EQ(load_experiment(files.write("my_exp.yaml", "schema: 1\n")).experiment.name, "my_exp");
}

}  // namespace
}  // namespace facet
