#include "experiment/gate_rounds.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.hpp"
#include "file/file_bytes.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;

/// Runs a program with its output in `log`; its exit code, or 128 + signal.
int run_program(const fs::path& program, const std::vector<std::string>& arguments, const fs::path& log) {
  std::vector<std::string> words{program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  pid_t child = 0;
  const int failed = ::posix_spawnp(&child, argv[0], &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0)
    throw Error(ErrorKind::usage,
                fmt::format("{}: cannot be started: {}", printable(program), std::strerror(failed)));
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// The one run directory below OUT/EXPERIMENT.
fs::path run_below(const fs::path& out) {
  std::error_code absent;
  for (const auto& experiment : fs::directory_iterator(out, absent))
    if (fs::exists(experiment.path() / "latest")) return fs::canonical(experiment.path() / "latest");
  return {};
}

RunRecord run_round(const fs::path& program, const GateRequest& request, const fs::path& out) {
  fs::create_directories(out);
  std::vector<std::string> arguments{"run"};
  arguments.insert(arguments.end(), request.arguments.begin(), request.arguments.end());
  arguments.insert(arguments.end(), {"--out", out.string(), "--no-progress"});
  const fs::path log = out / "output.txt";
  const int code = run_program(program, arguments, log);
  const fs::path run = run_below(out);
  constexpr int failed_frames = 5;
  if ((code == 0 || code == failed_frames) && !run.empty()) return read_run(run);
  const auto text =
      fs::exists(log) && fs::file_size(log) > 0 ? read_file_bytes(log) : std::vector<std::uint8_t>{};
  throw Error(
      ErrorKind::data,
      fmt::format("{} run {}: exit code {}:\n{}", printable(program), fmt::join(request.arguments, " "), code,
                  escaped_utf8({reinterpret_cast<const char*>(text.data()), text.size()})));
}

}  // namespace

GateRounds run_gate_rounds(const GateRequest& request, const std::string& series, RunObserver& observer) {
  GateRounds rounds;
  for (int round = 0; round < request.rounds; ++round) {
    observer.on_note(fmt::format("{}, round {} of {}", series, round + 1, request.rounds));
    const auto before = [&] {
      rounds.before.push_back(run_round(request.baseline_binary, request,
                                        request.out / fmt::format("{}{}_baseline", series, round + 1)));
    };
    const auto after = [&] {
      rounds.after.push_back(
          run_round(request.binary, request, request.out / fmt::format("{}{}_candidate", series, round + 1)));
    };
    if (round % 2 == 0) before();
    after();
    if (round % 2 == 1) before();
  }
  return rounds;
}

}  // namespace facet
