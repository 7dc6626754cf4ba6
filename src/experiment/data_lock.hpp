#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <string>

#include "dataset/dataset.hpp"

namespace facet {

/// Checksums of everything that was read: dataset.lock.json. Usable from several threads.
class DataLock {
 public:
  /// SHA-256 over the checksums of the frame's files; over its depth and camera where it was read from none.
  std::string input_hash(const Frame& frame);
  /// Checksum of every file seen so far, by data set; `roots` gives the folder that a data set's paths are
  /// relative to. A path belongs to the data set whose root it lies below.
  std::string to_json(const std::map<std::string, std::filesystem::path>& roots) const;

 private:
  std::string file_hash(const std::filesystem::path& file);

  mutable std::mutex mutex_;
  std::map<std::filesystem::path, std::string> hashes_;
};

}  // namespace facet
