#include "method/program.hpp"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <spawn.h>
#include <string_view>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "core/error.hpp"
#include "file/file_bytes.hpp"

extern char** environ;

namespace facet {
namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void fail_to_start(int error) {
  throw Error(ErrorKind::internal, fmt::format("no program can be started: {}", std::strerror(error)));
}

/// What posix_spawn does between the fork and the shell.
class SpawnRules {
 public:
  explicit SpawnRules(const ProgramRun& run) {
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
    posix_spawnattr_setpgroup(&attributes_, 0);
    sigset_t usual;  // an interrupt handler of ours must not stay ignored or blocked in theirs
    sigemptyset(&usual);
    for (const int signal : {SIGINT, SIGTERM, SIGPIPE}) sigaddset(&usual, signal);
    posix_spawnattr_setsigdefault(&attributes_, &usual);
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    constexpr int fresh = O_WRONLY | O_CREAT | O_TRUNC;
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, run.out_log.c_str(), fresh, 0644);
    posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, run.err_log.c_str(), fresh, 0644);
    if (!run.folder.empty()) posix_spawn_file_actions_addchdir_np(&actions_, run.folder.c_str());
  }
  ~SpawnRules() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  SpawnRules(const SpawnRules&) = delete;
  SpawnRules& operator=(const SpawnRules&) = delete;

  pid_t start(const std::string& command) const {
    std::string shell = "sh", option = "-c", text = command;
    char* const arguments[] = {shell.data(), option.data(), text.data(), nullptr};
    pid_t child = 0;
    const int error = posix_spawn(&child, "/bin/sh", &actions_, &attributes_, arguments, environ);
    if (error != 0) fail_to_start(error);
    return child;
  }

 private:
  posix_spawnattr_t attributes_{};
  posix_spawn_file_actions_t actions_{};
};

/// Waits until the child ends; false where that takes too long. It is not reaped yet, so that its process
/// group cannot become another's.
bool wait_until(pid_t child, Clock::time_point deadline) {
  while (true) {
    siginfo_t ended{};
    if (::waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT) != 0 && errno != EINTR)
      fail_to_start(errno);
    if (ended.si_pid == child) return true;
    if (Clock::now() >= deadline) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

/// The last line of a log that says anything, shortened.
std::string last_words(const std::filesystem::path& log) {
  std::ifstream input(log, std::ios::binary);
  std::string line, last;
  while (std::getline(input, line))
    if (line.find_first_not_of(" \t\r") != line.npos) last = line;
  constexpr std::size_t longest = 200;
  if (last.size() > longest) last.resize(longest);
  return last.empty() ? "" : ": " + escaped_utf8(last);
}

std::string how_it_ended(int status) {
  if (WIFSIGNALED(status))
    return fmt::format("the program was killed by signal {} ({})", WTERMSIG(status),
                       strsignal(WTERMSIG(status)));
  return fmt::format("the program exited with status {}", WEXITSTATUS(status));
}

}  // namespace

ProgramEnd run_program(const ProgramRun& run) {
  const auto start = Clock::now();
  const pid_t child = SpawnRules(run).start(run.command);
  const auto allowed =
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(run.timeout_s));
  const bool in_time = wait_until(child, start + allowed);
  ::kill(-child, SIGKILL);  // what it has left in the background too
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  ProgramEnd end;
  end.wall_ms = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  if (!in_time)
    end.failure = fmt::format("the program was killed after {:g} s (timeout_s)", run.timeout_s) +
                  last_words(run.err_log);
  else if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    end.failure = how_it_ended(status) + last_words(run.err_log);
  return end;
}

std::string shell_quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + '\'';
}

}  // namespace facet
