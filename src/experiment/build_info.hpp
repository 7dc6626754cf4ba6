#pragma once

#include <string>

namespace facet {

/// What this binary was built from.
struct BuildInfo {
  std::string version;
  std::string commit;  ///< 8 digits, or "unknown" outside a repository
  bool dirty = false;  ///< tracked files differed from the commit
  std::string compiler;
  std::string build_type;
  std::string flags;
  std::string cuda;  ///< version, or why there is none

  std::string name() const { return commit + (dirty ? "-dirty" : ""); }
};
const BuildInfo& build_info();

/// Names the program that computes the results: the commit, and for a changed tree the start of the
/// executable's checksum, because no commit tells two changed trees apart.
std::string build_identity();

}  // namespace facet
