#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/config_files.hpp"

namespace facet {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(ConfigErrors, AnUnknownKeyNamesFileLineColumnAndTheNearestKey) {
  ConfigFiles files;
  const std::string errors = files.errors_of("schema: 1\ntiming:\n  repeat: 5\n");
  EXPECT_THAT(errors, HasSubstr(files.at("exp.yaml",
                                         "3:3: timing.repeat: value 5: expected a key among warmup, "
                                         "repeats, threads; did you mean \"repeats\"?")));
}

TEST(ConfigErrors, AllErrorsOfAFileAreReportedInTheOrderOfItsLines) {
  ConfigFiles files;
  const std::string errors = files.errors_of(
      "schema: 1\nscore: 5\nseed: -1\nmethods:\n  - name: m\n    params: {wiener: {window_px: 4}, "
      "cd.high_deg: 181}\n");
  const auto score = errors.find("exp.yaml:2:8: score: value 5: expected a map of keys");
  const auto seed = errors.find("exp.yaml:3:7: seed: value -1: expected an integer in [0, 2147483647]");
  const auto window =
      errors.find("exp.yaml:6:34: methods.m.params.wiener.window_px: value 4: expected an odd integer");
  const auto high = errors.find("methods.m.params.cd.high_deg: value 181: expected a number in [0, 180] deg");
  ASSERT_NE(high, std::string::npos) << errors;
  EXPECT_LT(score, seed);
  EXPECT_LT(seed, window);
  EXPECT_LT(window, high);
}

TEST(ConfigErrors, ANumberWithALeadingZeroIsNoNumber) {
  ConfigFiles files;
  EXPECT_THAT(files.errors_of("schema: 1\ntiming: {repeats: 010}\n"), HasSubstr("timing.repeats: value 010"));
  EXPECT_THAT(files.errors_of("schema: 1\ntiming: {repeats: 0x10}\n"),
              HasSubstr("timing.repeats: value 0x10"));
}

TEST(ConfigErrors, QuotedTextIsNeitherANumberNorASwitch) {
  ConfigFiles files;
  EXPECT_THAT(files.errors_of("schema: 1\ntiming: {repeats: \"5\"}\n"),
              HasSubstr("value \"5\": expected an integer"));
  EXPECT_THAT(files.errors_of("schema: 1\nscore: {edges: \"true\"}\n"), HasSubstr("expected true or false"));
}

TEST(ConfigErrors, NumbersThatAreNotFiniteAreRejected) {
  ConfigFiles files;
  for (const std::string value : {".nan", ".inf", "nan", "1e999", "1e-999"})
    EXPECT_THAT(files.errors_of("schema: 1\nmethods: [{name: m, params: {cd.high_deg: " + value + "}}]\n"),
                HasSubstr("methods.m.params.cd.high_deg: value " + value));
}

TEST(ConfigErrors, ADuplicateKeyNamesBothPlaces) {
  ConfigFiles files;
  EXPECT_THAT(files.errors_of("schema: 1\nseed: 1\nname: x\nseed: 2\n"),
              HasSubstr(files.at("exp.yaml", "4:1: duplicate key \"seed\", first given at line 2")));
  EXPECT_THAT(files.errors_of(
                  "schema: 1\nmethods: [{name: m, params: {wiener: {window_px: 3}, wiener.window_px: 5}}]\n"),
              HasSubstr("duplicate key \"wiener.window_px\""));
}

TEST(ConfigErrors, MergeKeysAnchorsAliasesAndTagsAreRejected) {
  ConfigFiles files;
  const std::string errors =
      files.errors_of("schema: 1\ntiming: &t {repeats: 1}\nscore: *t\nname: !x y\noutputs: {<<: 1}\n");
  EXPECT_THAT(errors, HasSubstr("2:9: anchors are not supported"));
  EXPECT_THAT(errors, HasSubstr("3:8: aliases are not supported"));
  EXPECT_THAT(errors, HasSubstr("4:7: tags are not supported"));
  EXPECT_THAT(errors, HasSubstr("5:11: merge keys (<<) are not supported"));
}

TEST(ConfigErrors, AnEmptyValueIsReportedAtItsKey) {
  ConfigFiles files;
  EXPECT_THAT(files.errors_of("schema: 1\ntiming:\n  warmup:\n  repeats: 5\n"),
              HasSubstr(files.at("exp.yaml", "3:3: timing.warmup: value null")));
}

TEST(ConfigErrors, TheSchemaIsRequiredAndMustBeOne) {
  ConfigFiles files;
  EXPECT_THAT(files.errors_of("name: x\n"), HasSubstr("schema: missing"));
  EXPECT_THAT(files.errors_of("schema: 2\n"), HasSubstr("1:9: schema: value 2: expected 1"));
  EXPECT_THAT(files.errors_of(""), HasSubstr("expected a map with `schema: 1`"));
  EXPECT_THAT(files.errors_of("- 1\n"), HasSubstr("expected a map with `schema: 1`"));
}

TEST(ConfigErrors, BrokenYamlNamesThePlace) {
  ConfigFiles files;
  EXPECT_THAT(files.errors_of("schema: 1\ntiming: {repeats: 1\n"), HasSubstr("not valid YAML"));
  EXPECT_THAT(files.errors_of("schema: 1\ntiming: {repeats: 1\n"), HasSubstr("exp.yaml:"));
}

TEST(ConfigErrors, AMissingFileIsAnError) {
  ConfigFiles files;
  EXPECT_THROW(load_experiment(files.path() / "none.yaml"), Error);
}

TEST(ConfigErrors, DataSetsAndMethodsNeedNamesOfTheirOwn) {
  ConfigFiles files;
  EXPECT_THAT(files.errors_of("schema: 1\nmethods: [{name: a}, {name: a}]\n"),
              HasSubstr("a name that is used once"));
  EXPECT_THAT(files.errors_of("schema: 1\nmethods: [{name: ../a}]\n"), HasSubstr("expected letters, digits"));
  EXPECT_THAT(files.errors_of("schema: 1\nmethods: [{params: {}}]\n"),
              HasSubstr("expected a name of its own"));
  EXPECT_THAT(files.errors_of("schema: 1\nmethods: []\n"), HasSubstr("a list with at least one entry"));
}

TEST(ConfigErrors, AnUnknownReaderOptionAndAWrongTypeAreNamed) {
  ConfigFiles files;
  const std::string errors = files.errors_of(
      "schema: 1\ndatasets: [{name: f, reader: folder, root: x, depth_unit: 1, intrinsics: 5}]\n");
  EXPECT_THAT(errors, HasSubstr("did you mean \"depth_unit_m\"?"));
  EXPECT_THAT(errors, HasSubstr("datasets.f.intrinsics: value 5: expected a list of numbers"));
  EXPECT_THAT(files.errors_of("schema: 1\ndatasets: [ods]\n"), HasSubstr("did you mean \"osd\"?"));
}

TEST(ConfigErrors, ParametersThatContradictEachOtherAreNamed) {
  ConfigFiles files;
  EXPECT_THAT(files.errors_of("schema: 1\nmethods: [{name: m, params: {cd.high_deg: 5, cd.low_deg: 6}}]\n"),
              HasSubstr("methods.m.params.cd.low_deg"));
}

TEST(ConfigErrors, StudiesAreValidated) {
  ConfigFiles files;
  EXPECT_EQ(
      files.errors_of("schema: 1\nablation: {design: factorial, base: default, switches: [fill, wiener]}\n"
                      "sweep: {wiener.window_px: [3, 5]}\n"),
      "");
  const std::string errors =
      files.errors_of("schema: 1\nablation: {switches: [fil]}\nsweep: {wiener.window_px: [4]}\n");
  EXPECT_THAT(errors, HasSubstr("did you mean \"fill\"?"));
  EXPECT_THAT(errors, HasSubstr("3:28: sweep.wiener.window_px: value 4"));
}

TEST(ConfigErrors, KindsMustBeAsManyAsFrames) {
  ConfigFiles files;
  EXPECT_THAT(files.errors_of("schema: 1\ndatasets: [{name: osd, frames: [a, b], kinds: [Boxes]}]\n"),
              HasSubstr("expected a list with what each of `frames` shows"));
}

}  // namespace
}  // namespace facet
