#include "experiment/typed_value.hpp"

#include <charconv>
#include <cmath>
#include <regex>

namespace facet {
namespace {

bool plain_number(const ConfigValue& value) {
  static const std::regex decimal(R"([-+]?(0|[1-9][0-9]*)(\.[0-9]*)?([eE][-+]?[0-9]+)?)");
  return value.is_scalar() && !value.quoted && value.scalar.size() < 64 &&
         std::regex_match(value.scalar, decimal);
}

template <class T>
bool parse_whole(std::string_view text, T& out) {
  if (text.starts_with('+')) text.remove_prefix(1);
  T parsed{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), parsed);
  if (error != std::errc{} || end != text.data() + text.size()) return false;
  out = parsed;
  return true;
}

}  // namespace

bool read_typed(const ConfigValue& value, bool& out) {
  if (!value.is_scalar() || value.quoted || (value.scalar != "true" && value.scalar != "false")) return false;
  out = value.scalar == "true";
  return true;
}
bool read_typed(const ConfigValue& value, int& out) {
  return plain_number(value) && parse_whole(value.scalar, out);
}
bool read_typed(const ConfigValue& value, float& out) {
  return plain_number(value) && parse_whole(value.scalar, out);
}
bool read_typed(const ConfigValue& value, double& out) {
  return plain_number(value) && parse_whole(value.scalar, out);
}
bool read_typed(const ConfigValue& value, std::string& out) {
  if (!value.is_scalar() || value.scalar.empty()) return false;
  out = value.scalar;
  return true;
}

}  // namespace facet
