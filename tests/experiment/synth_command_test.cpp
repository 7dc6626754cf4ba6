#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/facet_process.hpp"

namespace facet {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::string spec_text =
    "schema: 1\nname: small\nsets:\n  - {name: boxes, scenes: boxes}\n"
    "  - {name: far, scenes: mixed, sensor: {model: azure_kinect}, vary: {distance_m: [0.3, 1.0]}}\n";

class SynthCommand : public ::testing::Test {
 protected:
  SynthCommand() { facet.write("spec.yaml", spec_text); }
  FacetProcess facet;
};

TEST_F(SynthCommand, WritesABenchmarkThatPassesItsValidationAndSaysWhatItWrote) {
  const auto result = facet.run({"synth", "spec.yaml", "--out", "data", "-j", "2"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("small: 2 frames, about 1 MB and 1 s with 2 threads"));
  EXPECT_THAT(result.out, HasSubstr("2 frames in 2 data sets are written below data"));
  EXPECT_THAT(result.out, HasSubstr("not written: far/distance_m_0.3_000: n/a (range)"));
  EXPECT_THAT(result.out, HasSubstr("1 frames not available, 0 frames with fewer objects"));
  EXPECT_THAT(result.err, HasSubstr("frames written: 2 of 2"));
  const auto valid = facet.run({"dataset", "validate", "data"});
  EXPECT_EQ(valid.exit_code, 0) << valid.out;
  EXPECT_THAT(valid.out, HasSubstr("2 annotations, 0 problems"));
  EXPECT_EQ(facet.run({"dataset", "verify", "data"}).exit_code, 0);
  const auto info = facet.run({"dataset", "info", "data"});
  EXPECT_THAT(info.out, HasSubstr("{name: boxes, reader: benchmark, root: data, set: boxes}"));
  EXPECT_THAT(facet.run({"dataset", "info", "data/boxes"}).out,
              HasSubstr("{name: boxes, reader: folder, root: data/boxes}"));
}

TEST_F(SynthCommand, CountsObjectsThatFoundNoRoom) {
  facet.write("full.yaml",
              "schema: 1\nname: full\nsets: [{name: a, scenes: clutter, vary: {objects: [60]}}]\n");
  const auto result = facet.run({"synth", "full.yaml", "--out", "data"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out,
              ::testing::ContainsRegex("shortfall: a/objects_60_000: [0-9]+ of 60 objects found room"));
  facet.write("exp.yaml",
              "schema: 1\ndatasets: [{name: d, reader: benchmark, root: full.yaml, cache: cache}]\n"
              "timing: {repeats: 0}\noutputs: {overlays: false}\n");
  const auto run = facet.run({"run", "exp.yaml", "-o", "out"});
  EXPECT_THAT(run.out,
              ::testing::ContainsRegex("data set d: objects_60_000: [0-9]+ of 60 objects found room"))
      << run.err;
  EXPECT_THAT(result.out, HasSubstr("1 frames with fewer objects than asked for"));
}

TEST_F(SynthCommand, TheSeedOfTheCommandLineIsThatOfTheSpecItLeaves) {
  ASSERT_EQ(facet.run({"synth", "spec.yaml", "--out", "a", "--seed", "5"}).exit_code, 0);
  EXPECT_THAT(file_text(facet.folder() / "a/spec.yaml"), HasSubstr("seed: 5\n"));
  ASSERT_EQ(facet.run({"synth", "a/spec.yaml", "--out", "b"}).exit_code, 0);
  EXPECT_EQ(contents_below(facet.folder() / "a"), contents_below(facet.folder() / "b"));
  ASSERT_EQ(facet.run({"synth", "spec.yaml", "--out", "c"}).exit_code, 0);
  EXPECT_NE(file_text(facet.folder() / "a/SHA256SUMS"), file_text(facet.folder() / "c/SHA256SUMS"));
}

TEST_F(SynthCommand, ADryRunSaysHowMuchAndWritesNothing) {
  const auto result = facet.run({"synth", "spec.yaml", "--dry-run"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.out, HasSubstr("2 frames"));
  EXPECT_EQ(facet.run({"synth", "spec.yaml"}).exit_code, 2);
}

TEST_F(SynthCommand, ABadSpecExitsThreeWithEveryProblemAndItsPlace) {
  facet.write("bad.yaml", "schema: 1\nname: x\nsets:\n  - {name: a, scenes: pyramids, count: 0}\n");
  const auto result = facet.run({"synth", "bad.yaml", "--out", "data"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("bad.yaml:4:23: sets[0].scenes"));
  EXPECT_THAT(result.err, HasSubstr("bad.yaml:4:40: sets[0].count"));
  EXPECT_EQ(facet.run({"synth", "nowhere.yaml", "--out", "data"}).exit_code, 3);
  EXPECT_FALSE(std::filesystem::exists(facet.folder() / "data"));
}

TEST_F(SynthCommand, AFolderThatHoldsSomethingExitsTwoAndOneThatCannotBeWrittenSeventy) {
  facet.write("file", "x");
  EXPECT_EQ(facet.run({"synth", "spec.yaml", "--out", "."}).exit_code, 2);
  EXPECT_EQ(facet.run({"synth", "spec.yaml", "--out", "file"}).exit_code, 2);
  EXPECT_EQ(facet.run({"synth", "spec.yaml", "--out", "file/data"}).exit_code, 70);
  const auto full = facet.run({"synth", "spec.yaml", "--out", "data"}, [] {
    const rlimit limit{512, 512};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  });
  EXPECT_EQ(full.exit_code, 70);
  EXPECT_THAT(full.err, HasSubstr("cannot be written"));
  EXPECT_EQ(facet.run({"dataset", "validate", "data"}).exit_code, 4);  // what is there is not a whole set
  EXPECT_EQ(facet.run({"dataset", "info", "data"}).exit_code, 4);
  EXPECT_EQ(facet.run({"synth", "spec.yaml", "--out", "data", "--seed", "2"}).exit_code, 2);
  EXPECT_EQ(facet.run({"synth", "spec.yaml", "--out", "data"}).exit_code, 0);  // taken up where it ended
  EXPECT_EQ(facet.run({"dataset", "validate", "data"}).exit_code, 0);
}

TEST_F(SynthCommand, ValidationExitsFourAndNamesFileShapeAndRuleOfEveryProblem) {
  ASSERT_EQ(facet.run({"synth", "spec.yaml", "--out", "data"}).exit_code, 0);
  const auto file = facet.folder() / "data/boxes/truth/boxes_000.json";
  std::string text = file_text(file);
  text.replace(text.find("\"edge/1\""), 8, "\"edge/2\"");
  facet.write("data/boxes/truth/boxes_000.json", text);
  facet.write("data/boxes/truth/other.json", "");
  const auto result = facet.run({"dataset", "validate", "data"});
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_THAT(result.out, ::testing::ContainsRegex("boxes_000.json: shape [0-9]+: .*edge/2"));
  EXPECT_THAT(result.out, HasSubstr("other.json: file is empty"));
  EXPECT_THAT(result.out, HasSubstr("boxes_000.json: the checksum differs"));
  EXPECT_EQ(facet.run({"dataset", "validate", "data/boxes/truth"}).exit_code, 4);
  EXPECT_EQ(facet.run({"dataset", "validate", "data/far"}).exit_code, 0);
  EXPECT_EQ(facet.run({"dataset", "validate", "data/far", "--masks", "nowhere"}).exit_code, 4);
  EXPECT_EQ(facet.run({"dataset", "validate", "data/boxes/color"}).exit_code, 4);
  EXPECT_EQ(facet.run({"dataset", "validate", "nowhere"}).exit_code, 4);
  EXPECT_EQ(facet.run({"dataset", "validate", "synthetic"}).exit_code, 4);
}

TEST_F(SynthCommand, AnExperimentNamesASpecAFolderOrASetOfItAndPredictsTheSame) {
  ASSERT_EQ(facet.run({"synth", "spec.yaml", "--out", "data"}).exit_code, 0);
  facet.write("exp.yaml",
              "schema: 1\ndatasets:\n  - {name: spec, reader: benchmark, root: spec.yaml, set: boxes}\n"
              "  - {name: folder, reader: benchmark, root: data, set: boxes}\n"
              "  - {name: set, reader: folder, root: data/boxes}\n"
              "timing: {repeats: 0}\noutputs: {overlays: false}\n");
  const auto cache = [this] { ::setenv("XDG_CACHE_HOME", (facet.folder() / "cache").c_str(), 1); };
  const auto result = facet.run({"run", "exp.yaml", "-o", "out", "-j", "2"}, cache);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(std::filesystem::is_directory(facet.folder() / "cache/facet/synth"));
  const auto run = facet.latest("out", "exp");
  const auto first = contents_below(run / "predictions/default/spec");
  EXPECT_FALSE(first.empty());
  EXPECT_EQ(first, contents_below(run / "predictions/default/folder"));
  EXPECT_EQ(first, contents_below(run / "predictions/default/set"));
  EXPECT_THAT(file_text(run / "dataset.lock.json"), HasSubstr("boxes/depth/boxes_000.png"));
}

}  // namespace
}  // namespace facet
