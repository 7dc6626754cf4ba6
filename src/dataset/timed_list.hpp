#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dataset/text_table.hpp"

namespace facet {

/// A file and when it was recorded.
struct TimedFile {
  double timestamp_s = 0;
  std::filesystem::path file;
};

/// A list `timestamp file`, in the order of time.
struct TimedList {
  std::vector<TimedFile> files;
  std::size_t broken_lines = 0;  ///< lines that are no entry
  std::size_t duplicates = 0;    ///< left out: an earlier entry has the time or the name of the file
  std::size_t missing = 0;       ///< left out: their file is not there
  std::size_t out_of_order = 0;  ///< moved to their place in time

  /// One sentence for each of the numbers above that is not 0; `name` is that of the list.
  std::vector<std::string> remarks(const std::string& name) const;
};

/// Files are relative to `root`.
TimedList timed_list(const std::vector<TextLine>& lines, const std::filesystem::path& root);

/// For every entry of `a` the index of its partner in `b`: pairs no farther apart than `tolerance_s`, the
/// closest first, every entry in one pair at most. Both lists are in the order of time.
std::vector<std::optional<std::size_t>> associate(const std::vector<TimedFile>& a,
                                                  const std::vector<TimedFile>& b, double tolerance_s);

/// "1 entry", "2 entries".
std::string entries_text(std::size_t count);

}  // namespace facet
