// The gate of the project itself: configs/gates, with the baseline that is stored there.
#include <algorithm>
#include <cstdlib>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>

#include "experiment/facet_process.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using Json = nlohmann::ordered_json;

const fs::path gates = FACET_CONFIGS "/gates";

class GateOfTheProject : public ::testing::Test {
 protected:
  ProcessResult gate(const fs::path& run) {
    return facet.run({"gate", run.string(), "--policy", (gates / "policy.yaml").string(), "--baseline",
                      (gates / "baseline").string(), "--json", "gate.json"});
  }
  /// The baseline as a run of its own, its rows of one method changed.
  template <class Change>
  fs::path changed_baseline(const Change& change) {
    const fs::path run = facet.folder() / "changed";
    fs::remove_all(run);
    fs::copy(gates / "baseline", run, fs::copy_options::recursive);
    std::istringstream lines(file_text(run / "frames.jsonl"));
    std::string line, text;
    for (int frame = 0; std::getline(lines, line);) {
      Json row = Json::parse(line);
      if (row.at("method") == "default") change(row.at("score"), frame++);
      text += row.dump() + '\n';
    }
    std::ofstream(run / "frames.jsonl") << text;
    return run;
  }
  FacetProcess facet;
};

TEST_F(GateOfTheProject, PassesThisBuild) {
  const auto run = facet.run({"run", (gates / "small.yaml").string(), "--set", "timing.warmup=1", "--set",
                              "timing.repeats=2", "-o", "out", "-q"},
                             [] { ::setenv("XDG_CACHE_HOME", "cache", 1); });
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto result = gate(facet.latest("out", "gate_small"));
  EXPECT_EQ(result.exit_code, 0)
      << result.err << "Where scores were meant to change, CONTRIBUTING.md tells how to renew the baseline.";
  const auto values = Json::parse(file_text(facet.folder() / "gate.json")).at("values");
  EXPECT_EQ(
      std::count_if(values.begin(), values.end(), [](const Json& v) { return v.at("name") == "total"; }), 2)
      << "times of both methods are reported";
}

TEST_F(GateOfTheProject, IsAlwaysRedForALossOfOnePoint) {
  int surfaces = 0, frames = 0;
  changed_baseline([&](Json& score, int) {
    surfaces += score.at("surfaces_50").at("truth").get<int>();
    ++frames;
  });
  const int point = (surfaces + 99) / 100;
  for (int damaged = 0; damaged < frames; damaged += 3) {
    int lost = 0;
    const auto run = changed_baseline([&](Json& score, int frame) {
      if (frame < damaged) return;
      Json& detected = score.at("surfaces_50").at("detected");
      for (; lost < point && detected > 0; ++lost) detected = detected.get<int>() - 1;
    });
    ASSERT_EQ(lost, point);
    const auto result = gate(run);
    EXPECT_EQ(result.exit_code, 1) << damaged;
    EXPECT_THAT(result.err, HasSubstr("regressed: surface_recall_0.5 of default on small"));
  }
}

TEST_F(GateOfTheProject, IsRedWhereARequiredScoreVanished) {
  const auto result =
      gate(changed_baseline([](Json& score, int) { score.at("annotated").at("edges") = false; }));
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("vanished: edge_recall_all_6px of default on small"));
}

}  // namespace
}  // namespace facet
