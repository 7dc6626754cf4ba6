#pragma once

#include <string>
#include <vector>

namespace facet {

/// Where a configuration value was written.
struct Origin {
  std::string source;  ///< file name as it was opened, or the text of a --set option; empty = built-in
  int line = 0;        ///< counted from 1; 0 where the source is not a file
  int column = 0;      ///< counted from 1

  /// "file:line:col", "--set key=value" or "built-in".
  std::string text() const;
};

struct ConfigEntry;

/// One node of a parsed configuration, with the mark of the place it came from. Scalars stay text until the
/// schema gives them a type.
struct ConfigValue {
  enum class Kind { null, scalar, list, map };

  Kind kind = Kind::null;
  std::string scalar;
  bool quoted = false;  ///< a quoted scalar is never a number, switch or null
  std::vector<ConfigValue> items;
  std::vector<ConfigEntry> entries;  ///< in file order
  Origin origin;

  bool is_map() const { return kind == Kind::map; }
  bool is_list() const { return kind == Kind::list; }
  bool is_scalar() const { return kind == Kind::scalar; }
  const ConfigEntry* find(const std::string& key) const;
  ConfigEntry* find(const std::string& key);
  /// Sets or replaces an entry.
  void set(ConfigEntry entry);
  void erase(const std::string& key);
  /// Short text for messages: the scalar, "null", "a list" or "a map".
  std::string describe() const;
};

struct ConfigEntry {
  std::string key;
  Origin key_origin;
  ConfigValue value;
};

}  // namespace facet
