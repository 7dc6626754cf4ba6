#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

namespace facet {

/// A file that grows line by line; every line is handed to the system whole. Usable from several threads.
class LineLog {
 public:
  /// Throws Error{internal} where the file cannot be opened for appending.
  explicit LineLog(std::filesystem::path file);
  ~LineLog();
  LineLog(const LineLog&) = delete;
  LineLog& operator=(const LineLog&) = delete;
  /// `line` ends with a line break. Throws Error{internal} where the disk is full.
  void append(std::string_view line);

 private:
  std::filesystem::path file_;
  std::mutex mutex_;
  int descriptor_ = -1;
};

/// The folder of one run: ROOT/EXPERIMENT/UTC_CONFIGHASH_BUILD, and the link `latest` beside it.
class RunDirectory {
 public:
  /// Makes a new one. Throws Error{usage} where `root` cannot hold folders.
  static RunDirectory create(const std::filesystem::path& root, const std::string& experiment,
                             const std::string& config_hash, const std::string& build);
  /// The newest one of the same configuration hash and build, nothing where there is none.
  static std::optional<RunDirectory> find(const std::filesystem::path& root, const std::string& experiment,
                                          const std::string& config_hash, const std::string& build);

  const std::filesystem::path& path() const { return path_; }
  /// Publishes a file by an atomic rename. Throws Error{internal} naming file and cause, a full disk for one.
  void publish(const std::filesystem::path& relative, std::string_view text) const;
  /// Points the link `latest` at this run.
  void become_latest() const;

 private:
  /// Throws Error{internal} where another process writes to it.
  explicit RunDirectory(std::filesystem::path path);
  std::filesystem::path path_;
  std::shared_ptr<const int> lock_;  ///< held until the last copy is gone, or the process
};

/// Now, as 2024-05-31T12:00:00Z; `compact` for names of folders, 20240531T120000Z.
std::string utc_now(bool compact = false);

}  // namespace facet
