#pragma once

#include <filesystem>
#include <string>

namespace facet {

/// A command for the shell, and where it runs.
struct ProgramRun {
  std::string command;            ///< for /bin/sh -c
  std::filesystem::path folder;   ///< where it runs; empty: here
  std::filesystem::path out_log;  ///< takes its standard output
  std::filesystem::path err_log;  ///< and its standard error
  double timeout_s = 60;
};

/// How a program ended.
struct ProgramEnd {
  double wall_ms = 0;   ///< from its start to its end, known to a millisecond
  std::string failure;  ///< empty: it exited with 0. Otherwise how it ended, and its last words
};

/// Runs a command in a process group of its own and waits for it, at most `timeout_s`; whatever of the group
/// is left then is killed. Throws Error{internal} where no process can be started.
ProgramEnd run_program(const ProgramRun& run);

/// `text` as one word of a shell's command line, whatever is in it.
std::string shell_quoted(const std::string& text);

}  // namespace facet
