#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/config_files.hpp"
#include "experiment/config_writer.hpp"

namespace facet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* two_methods =
    "schema: 1\ndatasets: [osd]\nmethods: [{name: a, params: {wiener.window_px: 3}}, {name: b}]\ntiming: "
    "{repeats: 2}\n";

Experiment with(const std::vector<std::string>& overrides) {
  ConfigFiles files;
  return load_experiment(files.write("exp.yaml", two_methods), overrides).experiment;
}

TEST(ConfigOverride, BeatsTheFile) {
  EXPECT_EQ(with({"timing.repeats=5"}).timing.repeats, 5);
}

TEST(ConfigOverride, TheLastOneOfAKeyHolds) {
  EXPECT_EQ(with({"timing.repeats=5", "timing.repeats=6"}).timing.repeats, 6);
}

TEST(ConfigOverride, ABareParameterAppliesToEveryMethod) {
  const Experiment e = with({"wiener.window_px=7"});
  EXPECT_EQ(e.methods[0].params.wiener.window_px, 7);
  EXPECT_EQ(e.methods[1].params.wiener.window_px, 7);
}

TEST(ConfigOverride, ANamedMethodAloneIsChanged) {
  const Experiment e = with({"methods.b.params.cd.high_deg=20.5"});
  EXPECT_EQ(e.methods[0].params.cd.high_deg, CreaseParams{}.high_deg);
  EXPECT_EQ(e.methods[1].params.cd.high_deg, 20.5f);
}

TEST(ConfigOverride, ADataSetGivenByItsNameCanBeChanged) {
  const Experiment e = with({"datasets.osd.frames=[learn6, test42]"});
  EXPECT_THAT(e.datasets[0].frames, ElementsAre("learn6", "test42"));
  EXPECT_EQ(e.datasets[0].root, "${data_root}/osd");
}

TEST(ConfigOverride, WorksOnTheBuiltInDataSetAndMethod) {
  ConfigFiles files;
  const auto loaded =
      load_experiment(files.write("exp.yaml", "schema: 1\n"),
                      {"methods.default.params.fill.enabled=false", "datasets.synthetic.frames=[box]"});
  EXPECT_FALSE(loaded.experiment.methods[0].params.fill.enabled);
  EXPECT_THAT(loaded.experiment.datasets[0].frames, ElementsAre("box"));
}

TEST(ConfigOverride, IsTypedByTheSchema) {
  ConfigFiles files;
  EXPECT_THAT(files.errors_of(two_methods, {"timing.repeats=abc"}),
              HasSubstr("--set timing.repeats=abc: timing.repeats: value abc: expected an integer"));
  EXPECT_THAT(files.errors_of(two_methods, {"wiener.window_px=4"}), HasSubstr("expected an odd integer"));
  EXPECT_THAT(files.errors_of(two_methods, {"wiener.gain=foo"}), HasSubstr("expected one of paper, lim"));
  EXPECT_THAT(files.errors_of(two_methods, {"seed=010"}), HasSubstr("value 010"));
}

TEST(ConfigOverride, UnknownPathsNameTheNearestOne) {
  ConfigFiles files;
  EXPECT_THAT(files.errors_of(two_methods, {"wiener.windw_px=3"}),
              HasSubstr("did you mean \"wiener.window_px\"?"));
  EXPECT_THAT(files.errors_of(two_methods, {"datasets.ods.frames=all"}), HasSubstr("did you mean \"osd\"?"));
  EXPECT_THAT(files.errors_of(two_methods, {"methods.c.params.fill.enabled=true"}),
              HasSubstr("the name of one of the methods"));
}

TEST(ConfigOverride, WithoutAnEqualsSignItIsAUsageError) {
  try {
    with({"timing.repeats"});
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::usage);
  }
}

TEST(ConfigOrigins, EveryValueSaysWhereItComesFrom) {
  ConfigFiles files;
  const std::string file = files.write("exp.yaml", two_methods);
  const std::string text = write_config_with_origins(load_experiment(file, {"cd.low_deg=3"}));
  EXPECT_THAT(text, HasSubstr("# " + file + ":4:19"));
  EXPECT_THAT(text, HasSubstr("cd.low_deg: 3"));
  EXPECT_THAT(text, HasSubstr("# --set cd.low_deg=3"));
  EXPECT_THAT(text, HasSubstr("# built-in"));
}

TEST(ConfigOrigins, TheResolvedConfigurationReadsBackAsTheSameExperiment) {
  ConfigFiles files;
  const auto loaded = load_experiment(files.write("exp.yaml", two_methods),
                                      {"cd.high_deg=20.1", "datasets.osd.frames=[\"1\", \"a: b\"]"});
  const std::string resolved = write_config(loaded.experiment);
  EXPECT_EQ(write_config(load_experiment(files.write("resolved.yaml", resolved)).experiment), resolved);
}

}  // namespace
}  // namespace facet
