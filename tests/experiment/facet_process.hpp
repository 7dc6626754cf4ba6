#pragma once

#include <csignal>
#include <cstdio>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <iterator>
#include <map>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include "support/temporary_folder.hpp"

namespace facet {

struct ProcessResult {
  int exit_code = -1;
  std::string out;
  std::string err;
};

inline std::string file_text(const std::filesystem::path& file) {
  std::ifstream input(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(input), {}};
}

/// The program itself, run in a folder of the test's own, with no data root in its environment.
class FacetProcess {
 public:
  const std::filesystem::path& folder() const { return folder_.path(); }
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder() / name) << text;
    return folder() / name;
  }
  /// Starts it; `prepare` runs in the child before the program.
  pid_t start(const std::vector<std::string>& arguments, const std::function<void()>& prepare = {}) const {
    const pid_t child = ::fork();
    if (child != 0) return child;
    if (std::freopen((folder() / "stdout").c_str(), "w", stdout) == nullptr ||
        std::freopen((folder() / "stderr").c_str(), "w", stderr) == nullptr || ::chdir(folder().c_str()) != 0)
      ::_exit(99);
    ::unsetenv("FACET_DATA");
    std::vector<char*> argv{const_cast<char*>(FACET_BINARY)};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    if (prepare) prepare();
    ::execv(argv[0], argv.data());
    ::_exit(98);
  }
  ProcessResult wait(pid_t child) const {
    int status = 0;
    ::waitpid(child, &status, 0);
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
    return {code, file_text(folder() / "stdout"), file_text(folder() / "stderr")};
  }
  ProcessResult run(const std::vector<std::string>& arguments,
                    const std::function<void()>& prepare = {}) const {
    return wait(start(arguments, prepare));
  }
  /// The run directory that `latest` of an experiment names.
  std::filesystem::path latest(const std::string& out, const std::string& experiment) const {
    return std::filesystem::canonical(folder() / out / experiment / "latest");
  }

 private:
  TemporaryFolder folder_;
};

/// Name -> content of every file below a folder.
inline std::map<std::string, std::string> contents_below(const std::filesystem::path& folder) {
  std::map<std::string, std::string> contents;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      contents[entry.path().lexically_relative(folder).string()] = file_text(entry.path());
  return contents;
}

}  // namespace facet
