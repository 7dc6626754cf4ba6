#include <cstdlib>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/facet_process.hpp"
#include "experiment/small_frames.hpp"

namespace facet {
namespace {

using ::testing::HasSubstr;

/// What must not depend on how a run was cut.
std::map<std::string, std::string> lasting_files(const std::filesystem::path& run) {
  auto files = contents_below(run / "predictions");
  files.merge(contents_below(run / "metrics"));
  for (const char* folder : {"overlays", "gallery", "strips"})
    if (std::filesystem::exists(run / folder)) files.merge(contents_below(run / folder));
  files["frames.jsonl"] = file_text(run / "frames.jsonl");
  files["dataset.lock.json"] = file_text(run / "dataset.lock.json");
  files["config.resolved.yaml"] = file_text(run / "config.resolved.yaml");
  return files;
}

class MergeCommand : public ::testing::Test {
 protected:
  MergeCommand() {
    write_small_frames(facet.folder() / "frames", {"f0", "f1", "f2", "f3", "f4", "f5", "f6"});
    facet.write("exp.yaml", "schema: 1\n" + small_dataset +
                                "methods: [{name: a}, {name: b, params: {wiener.enabled: false}}]\n"
                                "timing: {warmup: 1, repeats: 2}\n");
  }
  std::string run(const std::string& out, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"run", "exp.yaml", "-o", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto result = facet.run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return facet.latest(out, "exp").string();
  }
  ProcessResult merge(std::vector<std::string> shards) {
    shards.insert(shards.begin(), "merge");
    shards.insert(shards.end(), {"-o", "merged"});
    return facet.run(shards);
  }
  FacetProcess facet;
};

TEST_F(MergeCommand, ShardsGiveTheBytesOfTheWhole) {
  const std::string whole = run("whole");
  std::vector<std::string> shards;
  for (const char* shard : {"3/3", "1/3", "2/3"}) shards.push_back(run("parts", {"--shard", shard}));
  const auto merged = merge(shards);
  ASSERT_EQ(merged.exit_code, 0) << merged.err;
  EXPECT_EQ(lasting_files(facet.latest("merged", "exp")), lasting_files(whole));
  EXPECT_THAT(file_text(facet.latest("merged", "exp") / "timing/samples.csv"),
              HasSubstr("small,f6,b,steady,1"));
}

TEST_F(MergeCommand, TheWorstAndTheDisputedFramesAreThoseOfTheWhole) {
  facet.write("spec.yaml", "schema: 1\nname: s\nsets: [{name: set, scenes: boxes, count: 5}]\n");
  facet.write("exp.yaml",
              "schema: 1\ndatasets: [{name: set, reader: benchmark, root: spec.yaml, cache: cache}]\n"
              "methods: [{name: a}, {name: b, params: {wiener.enabled: false}}]\ntiming: {repeats: 0}\n"
              "outputs: {overlays: false, gallery: 2, disputed: 1}\n");
  const std::filesystem::path whole = run("whole");
  ASSERT_EQ(contents_below(whole / "gallery").size(), 2 + 4 + 1u) << "lists, two of each method, disputed";
  const auto merged = merge({run("parts", {"--shard", "1/2"}), run("parts", {"--shard", "2/2"})});
  ASSERT_EQ(merged.exit_code, 0) << merged.err;
  EXPECT_EQ(lasting_files(facet.latest("merged", "exp")), lasting_files(whole));
}

TEST_F(MergeCommand, AnAblationHasTheStripsOfTheWhole) {
  facet.write("exp.yaml", "schema: 1\n" + small_dataset +
                              "methods: [{name: paper}]\ntiming: {repeats: 0}\n"
                              "ablation: {design: leave_one_out, base: paper, switches: [fill, wiener]}\n");
  const auto ablate = [&](const std::string& out, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"ablate", "exp.yaml", "-o", out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto result = facet.run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return facet.latest(out, "exp").string();
  };
  const std::filesystem::path whole = ablate("whole", {});
  ASSERT_EQ(contents_below(whole / "strips").size(), 7u);
  const auto merged = merge({ablate("parts", {"--shard", "1/2"}), ablate("parts", {"--shard", "2/2"})});
  ASSERT_EQ(merged.exit_code, 0) << merged.err;
  EXPECT_EQ(lasting_files(facet.latest("merged", "exp")), lasting_files(whole));
}

TEST_F(MergeCommand, RefusesGapsAndDoubles) {
  const std::string first = run("parts", {"--shard", "1/3"}), second = run("parts", {"--shard", "2/3"});
  EXPECT_EQ(merge({first, second}).exit_code, 4);
  EXPECT_THAT(merge({first, second}).err, HasSubstr("shard 3/3 is missing"));
  EXPECT_THAT(merge({first, second, second}).err, HasSubstr("shard 2/3 stands 2 times"));
}

TEST_F(MergeCommand, RefusesWhatDoesNotBelongTogether) {
  const std::string first = run("parts", {"--shard", "1/2"});
  const std::string other = run("parts", {"--shard", "2/2", "--set", "seed=2"});
  EXPECT_THAT(merge({first, other}).err, HasSubstr("another configuration"));
  EXPECT_THAT(merge({first, run("whole")}).err, HasSubstr("not run with --shard"));
  const std::string second = run("parts", {"--shard", "2/2"});
  const std::string rows = file_text(std::filesystem::path(second) / "frames.jsonl");
  std::ofstream(std::filesystem::path(second) / "frames.jsonl") << rows.substr(0, rows.find('\n') + 1);
  EXPECT_THAT(merge({first, second}).err, HasSubstr("not finished"));
  EXPECT_FALSE(std::filesystem::exists(facet.folder() / "merged"));
}

TEST_F(MergeCommand, AShardIsAPartOfAWhole) {
  for (const char* shard : {"0/3", "4/3", "1", "1/", "a/b", "1/3x"}) {
    const auto result = facet.run({"run", "exp.yaml", "--shard", shard});
    EXPECT_EQ(result.exit_code, 2) << shard;
  }
  EXPECT_EQ(facet.run({"run", "exp.yaml", "--shard", "8/8"}).exit_code, 6);
}

TEST_F(MergeCommand, TheSlurmScriptRunsOneShardPerTask) {
  const std::string whole = run("whole", {"--set", "timing.repeats=0"});
  std::vector<std::string> shards;
  for (const char* task : {"4", "5", "6"}) {  // an array need not start at 1
    const std::string command =
        std::string("cd '") + facet.folder().string() + "' && FACET='" FACET_BINARY "'" +
        " SLURM_ARRAY_TASK_ID=" + task + " SLURM_ARRAY_TASK_MIN=4 SLURM_ARRAY_TASK_COUNT=3" +
        " SLURM_CPUS_PER_TASK=2 bash '" FACET_SCRIPTS "/slurm_array.sbatch' exp.yaml -o cluster" +
        " > slurm.log 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0) << file_text(facet.folder() / "slurm.log");
    shards.push_back(facet.latest("cluster", "exp").string());
  }
  const auto merged = merge(shards);
  ASSERT_EQ(merged.exit_code, 0) << merged.err;
  EXPECT_EQ(lasting_files(facet.latest("merged", "exp")), lasting_files(whole));
}

TEST_F(MergeCommand, AKilledShardIsResumedByTheSameCommand) {
  const std::string first = run("parts", {"--shard", "1/2"});
  std::string rows = file_text(std::filesystem::path(first) / "frames.jsonl");
  std::ofstream(std::filesystem::path(first) / "frames.jsonl") << rows.substr(0, rows.size() / 2);
  EXPECT_EQ(run("parts", {"--shard", "1/2", "--resume"}), first);
  EXPECT_EQ(file_text(std::filesystem::path(first) / "frames.jsonl"), rows);
}

}  // namespace
}  // namespace facet
