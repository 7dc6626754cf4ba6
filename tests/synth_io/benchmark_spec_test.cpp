#include "synth_io/benchmark_spec.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "file/file_bytes.hpp"
#include "support/temporary_folder.hpp"
#include "synth/frame_plan.hpp"

namespace facet {
namespace {

std::string problems_of(const std::string& text) {
  try {
    parse_benchmark_spec(text, "spec.yaml");
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::config);
    return error.what();
  }
  return "";
}

TEST(BenchmarkSpec, ReadsEveryKeyOfASet) {
  const BenchmarkSpec spec = parse_benchmark_spec(R"(schema: 1
name: example
seed: 7
sets:
  - name: first
    scenes: boxes
    count: 3
    sensor: {model: azure_kinect, reflectivity: 0.25, multipath: false, scale: 2}
    vary: {roll_deg: [0, 45]}
  - {name: second, scenes: mixed, seed: 9, frames: 5, distance_m: 1.5, path: {yaw_deg: 10, distance_m: 0.2}}
)",
                                                  "spec.yaml");
  ASSERT_EQ(spec.sets.size(), 2u);
  const SetSpec& first = spec.sets[0];
  EXPECT_EQ(first.sensor.model, Sensor::azure_kinect);
  EXPECT_FLOAT_EQ(first.sensor.azure_kinect.reflectivity, 0.25f);
  EXPECT_FLOAT_EQ(first.sensor.azure_kinect.scale, 2);
  EXPECT_FALSE(first.sensor.azure_kinect.multipath);
  EXPECT_EQ(first.vary, Vary::roll_deg);
  EXPECT_EQ(first.levels, (std::vector<double>{0, 45}));
  EXPECT_EQ(first.seed, 7u);
  EXPECT_EQ(spec.sets[1].seed, 9u);
  EXPECT_EQ(spec.sets[1].frames, 5);
  EXPECT_EQ(spec.sets[1].path_yaw_deg, 10);
}

TEST(BenchmarkSpec, AllProblemsAreNamedAtOnceWithTheirPlace) {
  const std::string text = problems_of(R"(schema: 2
name: x
colour: red
sets:
  - {name: a, scenes: pyramids}
  - {name: a, scenes: boxes, count: 0}
  - {name: B, scenes: boxes, vary: {roll_deg: [0], yaw_deg: [1]}}
  - {name: c, scenes: boxes, sensor: {model: kinect_v1, reflectivity: 1}, count: 2, count: 3}
)");
  for (const char* expected :
       {"spec.yaml:1:9: schema: found '2'", "spec.yaml:3:1: colour: unknown key",
        "sets[0].scenes: family: there is none called 'pyramids'", "spec.yaml:6:37: sets[1].count: found '0'",
        "sets[1].name: two sets are called 'a'", "sets[2].name: use lower case",
        "a set varies one thing only", "sets[3].sensor.reflectivity: unknown key",
        "sets[3].count: is given twice"}) {
    EXPECT_NE(text.find(expected), std::string::npos) << expected << "\n" << text;
  }
}

TEST(BenchmarkSpec, ImpossibleCombinationsAreNamed) {
  const auto problem = [](const std::string& set) {
    return problems_of("schema: 1\nname: x\nsets: [" + set + "]\n");
  };
  EXPECT_NE(problem("{name: a, scenes: crease}").find("belong together"), std::string::npos);
  EXPECT_NE(problem("{name: a, scenes: table2, vary: {objects: [3]}}").find("fixed number"),
            std::string::npos);
  EXPECT_NE(problem("{name: a, scenes: boxes, vary: {reflectivity: [0.5]}}").find("azure_kinect"),
            std::string::npos);
  EXPECT_NE(
      problem("{name: a, scenes: boxes, sensor: {model: stereo}, vary: {shadow: [0]}}").find("kinect_v1"),
      std::string::npos);
  EXPECT_NE(problem("{scenes: boxes}").find("sets[0].name: is missing"), std::string::npos);
}

TEST(BenchmarkSpec, ImpossibleLevelsAreNamedWithTheirPlace) {
  const auto problem = [](const std::string& vary) {
    return problems_of("schema: 1\nname: x\nsets: [{name: a, scenes: mixed, vary: {" + vary + "}}]\n");
  };
  EXPECT_NE(problem("objects: [1, 0]").find("3:53: sets[0].vary.objects: found '0'"), std::string::npos)
      << problem("objects: [1, 0]");
  EXPECT_NE(problem("objects: [2.5]").find("expected whole numbers"), std::string::npos);
  EXPECT_NE(problem("noise: [-1]").find("expected a number from 0 to 100"), std::string::npos);
  EXPECT_NE(problem("occlusion: [1.5]").find("sets[0].vary.occlusion"), std::string::npos);
  EXPECT_NE(problem("tilt_deg: [-10]").find("sets[0].vary.tilt_deg"), std::string::npos);
  EXPECT_NE(problem("yaw_deg: [5, 5]").find("a level is given twice"), std::string::npos);
}

TEST(BenchmarkSpec, AFrameThatCannotBeMadeNamesItsSetAndTheKey) {
  const auto error_of = [](const std::string& keys) -> std::string {
    const std::string text = "schema: 1\nname: x\nsets: [{name: a, scenes: mixed, " + keys + "}]\n";
    const BenchmarkSpec spec = parse_benchmark_spec(text, "spec.yaml");
    try {
      make_planned(spec.sets[0], plan_frames(spec.sets[0]).back());
    } catch (const Error& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_EQ(error_of("vary: {object_scale: [18]}").find("set 'a': object_scale_18_000: "), 0u);
  EXPECT_NE(error_of("distance_m: 0.3").find("distance_m"), std::string::npos);
  EXPECT_NE(error_of("frames: 2, path: {distance_m: -0.9}").find("path.distance_m"), std::string::npos);
}

TEST(BenchmarkSpec, ASeedPutInIsReadBackFromTheTextInEveryStyleOfFile) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "spec.yaml";
  for (const char* text : {"# note\nschema: 1\nname: x\nsets: [{name: a, scenes: boxes}]\n",
                           "schema: 1\nseed: 12 # twelve\nname: x\nsets: [{name: a, scenes: boxes}]\n",
                           "{schema: 1, seed: 12, name: x, sets: [{name: a, scenes: boxes}]}",
                           "  {schema: 1, name: x, sets: [{name: a, scenes: boxes}]}",
                           "---\n  name: x\n  schema: 1\n  sets: [{name: a, scenes: boxes}]\n"}) {
    write_file_atomically(file, std::string_view(text));
    const BenchmarkSpec spec = read_benchmark_spec(file, 77);
    EXPECT_EQ(spec.sets[0].seed, 77u) << text;
    EXPECT_EQ(parse_benchmark_spec(spec.text, file).sets[0].seed, 77u) << text;
  }
}

TEST(BenchmarkSpec, BrokenYamlAndWrongKindsOfFilesAreErrorsNotCrashes) {
  for (const char* text : {"", "[1, 2]", "schema: [", "sets: 3", "schema: 1\nname: x\nsets: []", "7"}) {
    EXPECT_FALSE(problems_of(text).empty()) << text;
  }
  EXPECT_THROW(read_benchmark_spec("/nonexistent/spec.yaml"), Error);
}

}  // namespace
}  // namespace facet
