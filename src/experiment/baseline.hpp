#pragma once

#include <filesystem>
#include <string>

namespace facet {

/// Who made which run the baseline, when and why.
struct BaselineEntry {
  std::string who, when_utc, reason;
  std::string run;  ///< name of the run directory
  std::string build, config_hash;
};

/// Copies the stored rows of a finished run (no predictions, no pictures) to `folder`, in place of those that
/// were there, and adds a line to its history.jsonl. Throws Error{usage} for an empty reason, Error{data}
/// where `run` is no finished run. Returns what was recorded.
BaselineEntry update_baseline(const std::filesystem::path& run, const std::filesystem::path& folder,
                              const std::string& reason, const std::string& who);

/// Where the baseline of a run is by default: beside its run directory, "baseline".
std::filesystem::path default_baseline(const std::filesystem::path& run);

/// The user's name and this machine's, "ada@pc".
std::string user_at_machine();

}  // namespace facet
