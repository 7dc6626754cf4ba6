#pragma once

#include <string>

namespace facet {

/// A part of a run: number `index` of `count`.
struct Shard {
  int index = 1;  ///< from 1
  int count = 1;

  bool is_whole() const { return count == 1; }
  /// "2/4", empty for the whole.
  std::string text() const { return is_whole() ? "" : std::to_string(index) + '/' + std::to_string(count); }
};

/// Reads "2/4". Throws Error{usage} for anything that is no part of a whole.
Shard parse_shard(const std::string& text);

}  // namespace facet
