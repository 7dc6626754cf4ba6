#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "experiment/config_errors.hpp"
#include "experiment/typed_value.hpp"

namespace facet {

/// Path of a value ("timing.repeats") -> where it was written. Paths that are absent keep their built-in
/// value.
using OriginTable = std::map<std::string, Origin, std::less<>>;

/// Reads one map of a configuration, key by key: a visitor for the field lists. Errors are collected, never
/// thrown.
class SectionReader {
 public:
  SectionReader(const ConfigValue& section, std::string path, ConfigErrors& errors, OriginTable& origins);

  /// Reads a key into `member` where the section has it.
  template <class T>
  void operator()(std::string_view key, T& member, const FieldInfo& info) {
    const ConfigValue* value = take(key);
    if (value == nullptr) return;
    T read = member;
    if (read_typed(*value, read) && in_range(read, info))
      member = read;
    else
      reject(*value, key, expectation<T>(info), enum_suggestion<T>(*value));
  }
  /// The value of a key that is read by other means, null where it is absent.
  const ConfigValue* take(std::string_view key);
  /// The items of a key that must hold a list; empty where it is absent.
  std::vector<ConfigValue> take_list(std::string_view key, const std::string& expected);
  /// Adds an error for the value of a key.
  void reject(const ConfigValue& value, std::string_view key, const std::string& expected,
              const std::string& suggestion = {});
  /// Reports every key that nothing has asked for, with the nearest one that exists.
  void finish();
  std::string path_of(std::string_view key) const;

 private:
  template <class T>
  static std::string enum_suggestion(const ConfigValue& value) {
    if constexpr (std::is_enum_v<T>)
      return nearest_name(value.scalar, {enum_names<T>.begin(), enum_names<T>.end()});
    return {};
  }

  const ConfigValue& section_;
  std::string path_;
  ConfigErrors& errors_;
  OriginTable& origins_;
  std::vector<std::string> known_;
};

}  // namespace facet
