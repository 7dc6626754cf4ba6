#include "experiment/section_reader.hpp"

#include <algorithm>
#include <fmt/ranges.h>

namespace facet {

SectionReader::SectionReader(const ConfigValue& section, std::string path, ConfigErrors& errors,
                             OriginTable& origins)
    : section_(section), path_(std::move(path)), errors_(errors), origins_(origins) {
  if (!section.is_map())
    errors_.add(section.origin, path_.empty() ? "(file)" : path_, section.describe(), "a map of keys");
}

const ConfigValue* SectionReader::take(std::string_view key) {
  known_.emplace_back(key);
  const ConfigEntry* entry = section_.find(known_.back());
  if (entry == nullptr) return nullptr;
  origins_[path_of(key)] = entry->value.origin;
  return &entry->value;
}

std::vector<ConfigValue> SectionReader::take_list(std::string_view key, const std::string& expected) {
  const ConfigValue* value = take(key);
  if (value == nullptr) return {};
  if (value->is_list() && !value->items.empty()) return value->items;
  reject(*value, key, expected);
  return {};
}

void SectionReader::reject(const ConfigValue& value, std::string_view key, const std::string& expected,
                           const std::string& suggestion) {
  errors_.add(value.origin, path_of(key), value.describe(), expected, suggestion);
}

void SectionReader::finish() {
  const std::string expected =
      known_.size() <= 12 ? fmt::format("a key among {}", fmt::join(known_, ", ")) : "a known key";
  for (const ConfigEntry& entry : section_.entries) {
    if (std::find(known_.begin(), known_.end(), entry.key) != known_.end()) continue;
    errors_.add(entry.key_origin, path_of(entry.key), entry.value.describe(), expected,
                nearest_name(entry.key, known_));
  }
}

std::string SectionReader::path_of(std::string_view key) const {
  return path_.empty() ? std::string(key) : path_ + '.' + std::string(key);
}

}  // namespace facet
