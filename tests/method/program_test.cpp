#include "method/program.hpp"

#include <chrono>
#include <csignal>
#include <fstream>
#include <gtest/gtest.h>
#include <thread>

#include "support/temporary_folder.hpp"

namespace facet {
namespace {

class Program : public ::testing::Test {
 protected:
  ProgramEnd run(const std::string& command, double timeout_s = 30) {
    return run_program({command, folder_.path(), folder_.path() / "out", folder_.path() / "err", timeout_s});
  }
  std::string text(const std::string& name) const {
    std::ifstream input(folder_.path() / name);
    return {std::istreambuf_iterator<char>(input), {}};
  }

  TemporaryFolder folder_;
};

TEST_F(Program, RunsInItsFolderAndItsOutputIsKept) {
  const ProgramEnd end = run("pwd; echo warned >&2");
  EXPECT_EQ(end.failure, "");
  EXPECT_GT(end.wall_ms, 0);
  EXPECT_EQ(text("out"), std::filesystem::canonical(folder_.path()).string() + '\n');
  EXPECT_EQ(text("err"), "warned\n");
}

TEST_F(Program, AnExitStatusAndASignalAreFailuresWithTheLastWords) {
  EXPECT_EQ(run("echo first >&2; echo no memory >&2; echo >&2; exit 3").failure,
            "the program exited with status 3: no memory");
  EXPECT_EQ(run("kill -SEGV $$").failure, "the program was killed by signal 11 (Segmentation fault)");
  EXPECT_NE(run("there-is-no-such-program").failure.find("status 127"), std::string::npos);
}

TEST_F(Program, AHangingProgramIsKilledWithAllThatItStarted) {
  const ProgramEnd end = run("sleep 60 & echo $! > child; wait", 0.3);
  EXPECT_EQ(end.failure, "the program was killed after 0.3 s (timeout_s)");
  pid_t child = 0;
  std::ifstream(folder_.path() / "child") >> child;
  ASSERT_GT(child, 0);
  // Its parent is gone; whoever inherits it reaps it in its own time.
  for (int i = 0; i < 500 && ::kill(child, 0) == 0; ++i) {
    std::ifstream stat("/proc/" + std::to_string(child) + "/stat");
    std::string line;
    std::getline(stat, line);
    if (line.find(") Z ") != line.npos) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_NE(::kill(child, 0), 0);
}

TEST_F(Program, WordsOfTheShellKeepWhatIsInThem) {
  const std::string awkward = "it's $HOME; `rm` \"x\"\n\\";
  run("printf %s " + shell_quoted(awkward));
  EXPECT_EQ(text("out"), awkward);
}

}  // namespace
}  // namespace facet
