#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "experiment/facet_process.hpp"
#include "experiment/small_frames.hpp"

namespace facet {
namespace {

using ::testing::HasSubstr;

// Tolerant enough for any machine: what is tested is the way through the program, not its speed.
const std::string tolerant_policy = "schema: 1\nlatency: {total: {abs: 1000, required: true}}\n";

class GateCommand : public ::testing::Test {
 protected:
  GateCommand() {
    write_small_frames(facet.folder() / "frames", {"f0", "f1", "f2", "f3"});
    facet.write("exp.yaml", small_experiment);
    facet.write("policy.yaml", tolerant_policy);
  }
  std::string run(const std::string& out, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"run", "exp.yaml", "-o", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(facet.run(arguments).exit_code, 0);
    return facet.latest(out, "exp").string();
  }
  FacetProcess facet;
};

TEST_F(GateCommand, PassesARunAgainstTheBaselineItWasMade) {
  const std::string first = run("out");
  const auto update = facet.run({"baseline", "update", first, "--reason", "a first one", "--who", "ada"});
  EXPECT_EQ(update.exit_code, 0) << update.err;
  const auto history = nlohmann::json::parse(file_text(facet.folder() / "out/exp/baseline/history.jsonl"));
  EXPECT_EQ(history.at("who"), "ada");
  EXPECT_EQ(history.at("reason"), "a first one");
  EXPECT_EQ(first.substr(first.rfind('/') + 1), history.at("run"));
  const auto gate =
      facet.run({"gate", run("out"), "--policy", "policy.yaml", "--junit", "j.xml", "--json", "g.json"});
  EXPECT_EQ(gate.exit_code, 0) << gate.err;
  EXPECT_THAT(gate.out, HasSubstr("Comparison: passed"));
  EXPECT_THAT(file_text(facet.folder() / "j.xml"), HasSubstr("<testcase name=\"total\""));
  EXPECT_EQ(nlohmann::json::parse(file_text(facet.folder() / "g.json")).at("passed"), true);
}

TEST_F(GateCommand, FailsWhereAMethodOrATimeVanished) {
  const std::string whole = run("whole");
  facet.write("exp.yaml", small_experiment + "name: exp\n");
  const std::string untimed = run("untimed", {"--set", "timing.repeats=0"});
  const auto gate =
      facet.run({"gate", untimed, "--baseline", whole, "--policy", "policy.yaml", "--ci", "github"});
  EXPECT_EQ(gate.exit_code, 1);
  EXPECT_THAT(gate.out, HasSubstr("::error title=facet gate::vanished: total of a on small"));
  EXPECT_EQ(facet.run({"compare", whole, untimed}).exit_code, 1);
  EXPECT_EQ(facet.run({"compare", whole, whole}).exit_code, 0);
}

TEST_F(GateCommand, SaysWhatIsMissing) {
  const std::string run_directory = run("out");
  const auto no_baseline = facet.run({"gate", run_directory, "--policy", "policy.yaml"});
  EXPECT_EQ(no_baseline.exit_code, 6);
  EXPECT_THAT(no_baseline.err, HasSubstr("baseline update"));
  facet.write("bad.yaml", "schema: 1\nlatency: {totl: {rel: 0.1}}\naccuracy: {pq: {rel: -1}}\n");
  const auto bad = facet.run({"gate", run_directory, "--policy", "bad.yaml"});
  EXPECT_EQ(bad.exit_code, 3);
  EXPECT_THAT(bad.err, HasSubstr("bad.yaml:2:11: latency.totl"));
  EXPECT_THAT(bad.err, HasSubstr("accuracy.pq.rel"));
  EXPECT_EQ(facet.run({"gate", run_directory, "--policy", "policy.yaml", "--binary", "x"}).exit_code, 2);
  EXPECT_EQ(facet.run({"baseline", "update", run_directory, "--reason", " "}).exit_code, 2);
  EXPECT_EQ(facet.run({"compare", run_directory, "nowhere"}).exit_code, 4);
}

TEST_F(GateCommand, RunsTwoBuildsInTurn) {
  const auto gate = facet.run({"gate", "exp.yaml", "--policy", "policy.yaml", "--binary", FACET_BINARY,
                               "--baseline-binary", FACET_BINARY, "--rounds", "2", "--json", "g.json"});
  EXPECT_EQ(gate.exit_code, 0) << gate.err;
  const auto values = nlohmann::json::parse(file_text(facet.folder() / "g.json")).at("values");
  ASSERT_EQ(values.size(), 2u);     // two methods
  EXPECT_EQ(values[0].at("n"), 8);  // four frames, two rounds
  const auto broken = facet.run({"gate", "none.yaml", "--policy", "policy.yaml", "--binary", FACET_BINARY,
                                 "--baseline-binary", FACET_BINARY});
  EXPECT_EQ(broken.exit_code, 4);
  EXPECT_THAT(broken.err, HasSubstr("none.yaml"));
}

}  // namespace
}  // namespace facet
