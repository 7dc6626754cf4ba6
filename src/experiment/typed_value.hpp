#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <string>
#include <type_traits>

#include "experiment/config_value.hpp"
#include "pipeline/params_fields.hpp"

namespace facet {

/// Strict scalars: `true`/`false`; decimal integers without leading zeros; finite decimal numbers. Quoted
/// text is a string and nothing else, `010`, `0x8`, `yes` and `.nan` are neither numbers nor switches. False
/// where `value` is not of the type; `out` is untouched then.
bool read_typed(const ConfigValue& value, bool& out);
bool read_typed(const ConfigValue& value, int& out);
bool read_typed(const ConfigValue& value, float& out);
bool read_typed(const ConfigValue& value, double& out);
bool read_typed(const ConfigValue& value, std::string& out);
template <class Enum>
requires std::is_enum_v<Enum>
bool read_typed(const ConfigValue& value, Enum& out) {
  if (!value.is_scalar()) return false;
  const auto parsed = parse_enum<Enum>(value.scalar);
  if (parsed) out = *parsed;
  return parsed.has_value();
}

template <class T>
bool in_range(const T& value, const FieldInfo& info) {
  if constexpr (std::is_same_v<T, int>)
    return value >= info.min && value <= info.max && !(info.odd && value % 2 == 0);
  if constexpr (std::is_floating_point_v<T>) return value >= info.min && value <= info.max;
  return true;
}

/// "an odd integer in [3, 15] px", "one of paper, lim": for messages and for the documentation.
template <class T>
std::string expectation(const FieldInfo& info) {
  const std::string unit = info.unit.empty() ? "" : fmt::format(" {}", info.unit);
  if constexpr (std::is_same_v<T, bool>)
    return "true or false";
  else if constexpr (std::is_same_v<T, int>)
    return fmt::format("an {}integer in [{}, {}]{}", info.odd ? "odd " : "", info.min, info.max, unit);
  else if constexpr (std::is_floating_point_v<T>)
    return fmt::format("a number in [{}, {}]{}", info.min, info.max, unit);
  else if constexpr (std::is_enum_v<T>)
    return fmt::format("one of {}", fmt::join(enum_names<T>, ", "));
  else
    return "text";
}

/// The value as a config file spells it.
template <class T>
std::string spell(const T& value) {
  if constexpr (std::is_enum_v<T>)
    return std::string(enum_name(value));
  else
    return fmt::format("{}", value);
}

}  // namespace facet
