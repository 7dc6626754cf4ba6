#include <algorithm>
#include <chrono>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <thread>

#include "experiment/facet_process.hpp"
#include "experiment/small_frames.hpp"

namespace facet {
namespace {

using ::testing::HasSubstr;

std::map<std::string, std::string> lasting_files(const std::filesystem::path& run) {
  auto files = contents_below(run / "predictions");
  files.merge(contents_below(run / "metrics"));
  files["frames.jsonl"] = file_text(run / "frames.jsonl");
  return files;
}

class InterruptedRun : public ::testing::Test {
 protected:
  InterruptedRun() {
    std::vector<std::string> ids;
    for (int i = 0; i < 24; ++i) ids.push_back(std::string("f").append(std::to_string(i)));
    write_small_frames(facet.folder() / "frames", ids);
    facet.write("exp.yaml", small_experiment);
  }
  std::vector<std::string> command(const std::string& out, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"run", "exp.yaml", "-o", out, "-j", "2", "--set", "timing.repeats=0"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  /// Waits until the newest run below `out` has that much of frames.jsonl; false where it never has.
  bool wait_for_rows(const std::string& out, std::uintmax_t bytes) const {
    const auto rows = facet.folder() / out / "exp/latest/frames.jsonl";
    for (int i = 0; i < 5000; ++i) {
      std::error_code absent;
      const auto size = std::filesystem::file_size(rows, absent);
      if (!absent && size >= bytes) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
  }
  FacetProcess facet;
};

TEST_F(InterruptedRun, KilledAnywhereAndResumedGivesTheSameBytes) {
  ASSERT_EQ(facet.run(command("whole")).exit_code, 0);
  const auto whole = lasting_files(facet.latest("whole", "exp"));
  const std::uintmax_t all = whole.at("frames.jsonl").size();
  for (const std::uintmax_t tenth : {0, 1, 3, 5, 7, 9}) {
    const std::string out = std::string("killed").append(std::to_string(tenth));
    const pid_t child = facet.start(command(out));
    ASSERT_TRUE(wait_for_rows(out, tenth * all / 10));
    ::kill(child, SIGKILL);
    facet.wait(child);
    const auto resumed = facet.run(command(out, {"--resume"}));
    ASSERT_EQ(resumed.exit_code, 0) << resumed.err;
    EXPECT_EQ(lasting_files(facet.latest(out, "exp")), whole) << "killed at " << tenth << " tenths";
  }
}

TEST_F(InterruptedRun, AFullDiskLosesNothingThatWasMeasured) {
  ASSERT_EQ(facet.run(command("whole")).exit_code, 0);
  const auto whole = lasting_files(facet.latest("whole", "exp"));
  const std::size_t half = whole.at("frames.jsonl").size() / 2;
  const auto full = facet.run(command("full"), [half] {
    const rlimit limit{half, half};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  });
  EXPECT_EQ(full.exit_code, 70);
  EXPECT_THAT(full.err, HasSubstr("cannot be written"));
  const auto run = facet.latest("full", "exp");
  EXPECT_EQ(file_text(run / "frames.jsonl").size(), half) << "it stopped at the limit";
  const auto resumed = facet.run(command("full", {"--resume"}));
  ASSERT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_EQ(facet.latest("full", "exp"), run);
  EXPECT_THAT(file_text(run / "log.jsonl"), HasSubstr("\"event\":\"kept\""));
  EXPECT_EQ(lasting_files(run), whole);
}

TEST_F(InterruptedRun, ASecondWriterIsTurnedAwayAndTheFirstFinishes) {
  const pid_t first = facet.start(command("out"));
  ASSERT_TRUE(wait_for_rows("out", 0));
  ::kill(first, SIGSTOP);  // holds the run while the second one tries
  const auto second = facet.run(command("out", {"--resume"}));
  EXPECT_EQ(second.exit_code, 70);
  EXPECT_THAT(second.err, HasSubstr("another process writes to this run"));
  ::kill(first, SIGCONT);
  EXPECT_EQ(facet.wait(first).exit_code, 0);
  const auto stored = file_text(facet.latest("out", "exp") / "frames.jsonl");
  EXPECT_EQ(std::count(stored.begin(), stored.end(), '\n'), 48);
}

}  // namespace
}  // namespace facet
