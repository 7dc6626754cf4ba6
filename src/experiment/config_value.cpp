#include "experiment/config_value.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace facet {

std::string Origin::text() const {
  if (source.empty()) return "built-in";
  return line > 0 ? fmt::format("{}:{}:{}", source, line, column) : source;
}

const ConfigEntry* ConfigValue::find(const std::string& key) const {
  const auto found =
      std::find_if(entries.begin(), entries.end(), [&](const auto& e) { return e.key == key; });
  return found == entries.end() ? nullptr : &*found;
}

ConfigEntry* ConfigValue::find(const std::string& key) {
  return const_cast<ConfigEntry*>(std::as_const(*this).find(key));
}

void ConfigValue::set(ConfigEntry entry) {
  if (ConfigEntry* existing = find(entry.key))
    *existing = std::move(entry);
  else
    entries.push_back(std::move(entry));
}

void ConfigValue::erase(const std::string& key) {
  std::erase_if(entries, [&](const auto& e) { return e.key == key; });
}

std::string ConfigValue::describe() const {
  switch (kind) {
    case Kind::null:
      return "null";
    case Kind::list:
      return "a list";
    case Kind::map:
      return "a map";
    default:
      return quoted ? fmt::format("\"{}\"", scalar) : scalar;
  }
}

}  // namespace facet
