#pragma once

#include <stdexcept>
#include <string>

namespace facet {

/// What went wrong, in the classes that the command line's exit codes distinguish.
enum class ErrorKind {
  usage,         ///< the command line cannot be understood: exit 2
  config,        ///< an experiment file is wrong: exit 3
  data,          ///< data, annotation or prediction missing or corrupt: exit 4
  not_measured,  ///< nothing to measure, or not on this machine: exit 6
  internal,      ///< a broken promise of our own code, or a full disk: exit 70
};

/// The one exception type of the libraries: thrown for a broken contract or failed I/O, caught once in
/// tools/. The message names the file (or key) and the rule that was broken.
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}
  ErrorKind kind() const { return kind_; }

 private:
  ErrorKind kind_;
};

}  // namespace facet
