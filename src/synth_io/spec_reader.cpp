#include "synth_io/spec_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "core/error.hpp"
#include "file/file_bytes.hpp"

namespace facet {
namespace {

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

bool parse_number(const std::string& text, double& out) {
  const auto result = std::from_chars(text.data(), text.data() + text.size(), out);
  return result.ec == std::errc{} && result.ptr == text.data() + text.size() && std::isfinite(out);
}

std::string short_text(double v) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, v).ptr;
  return {buffer, end};
}

}  // namespace

void SpecProblems::add(const YAML::Node& at, const std::string& path, const std::string& rule) {
  const YAML::Mark mark = at.IsDefined() ? at.Mark() : YAML::Mark{};
  const int line = std::max(0, mark.line) + 1, column = std::max(0, mark.column) + 1;
  lines_.push_back(printable(file_) + ":" + std::to_string(line) + ":" + std::to_string(column) + ": " +
                   path + ": " + rule);
}

void SpecProblems::throw_if_any() const {
  if (lines_.empty()) return;
  std::string message;
  for (const std::string& line : lines_) message += (message.empty() ? "" : "\n") + line;
  throw Error(ErrorKind::config, message);
}

MapReader::MapReader(YAML::Node map, std::string path, SpecProblems& problems)
    : map_(std::move(map)), path_(std::move(path)), problems_(problems) {
  if (!map_.IsMap()) problems_.add(map_, path_.empty() ? "file" : path_, "expected a map of keys and values");
}

YAML::Node MapReader::find(const char* key) {
  known_.push_back(key);
  if (!map_.IsMap()) return YAML::Node(YAML::NodeType::Undefined);
  for (const auto& entry : map_) {
    if (entry.first.IsScalar() && entry.first.Scalar() == key) return entry.second;
  }
  return YAML::Node(YAML::NodeType::Undefined);
}

void MapReader::problem(const char* key, const std::string& rule) {
  YAML::Node at = map_;
  if (map_.IsMap()) {
    for (const auto& entry : map_) {
      if (entry.first.IsScalar() && entry.first.Scalar() == key)
        at.reset(entry.second);  // = would change the file's own tree
    }
  }
  problems_.add(at, path_ + key, rule);
}

bool MapReader::read_number(const YAML::Node& node, const std::string& key, double low, double high,
                            double& out) {
  const bool is_number = node.IsScalar() && parse_number(node.Scalar(), out);
  if (is_number && out >= low && out <= high) return true;
  const std::string found = node.IsScalar() ? "'" + node.Scalar() + "'" : "no number";
  problems_.add(node, path_ + key,
                "found " + found + ", expected a number from " + short_text(low) + " to " + short_text(high));
  return false;
}

void MapReader::number(const char* key, double low, double high, const std::function<void(double)>& set) {
  const YAML::Node node = find(key);
  double value = 0;
  if (node.IsDefined() && read_number(node, key, low, high, value)) set(value);
}

void MapReader::integer(const char* key, double low, double high, const std::function<void(long long)>& set) {
  number(key, low, high, [&](double value) {
    if (value != std::floor(value)) return problem(key, "expected a whole number");
    set(static_cast<long long>(value));
  });
}

void MapReader::flag(const char* key, const std::function<void(bool)>& set) {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) return;
  const std::string text = node.IsScalar() ? node.Scalar() : "";
  if (text != "true" && text != "false") return problems_.add(node, path_ + key, "expected true or false");
  set(text == "true");
}

void MapReader::text(const char* key, const std::function<void(const std::string&)>& set) {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) return;
  if (!node.IsScalar() || node.Scalar().empty()) return problems_.add(node, path_ + key, "expected a text");
  set(node.Scalar());
}

void MapReader::choice(const char* key, const std::vector<std::string>& names,
                       const std::function<void(std::size_t)>& set) {
  text(key, [&](const std::string& value) {
    const auto place = std::find(names.begin(), names.end(), value);
    if (place == names.end()) return problem(key, "found '" + value + "', expected one of " + joined(names));
    set(static_cast<std::size_t>(place - names.begin()));
  });
}

void MapReader::numbers(const char* key, double low, double high,
                        const std::function<void(const std::vector<double>&)>& set) {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) return;
  if (!node.IsSequence() || node.size() == 0)
    return problems_.add(node, path_ + key, "expected a list of numbers");
  std::vector<double> values;
  for (const auto& item : node) {
    double value = 0;
    if (read_number(item, key, low, high, value)) values.push_back(value);
  }
  if (values.size() == node.size()) set(values);
}

void MapReader::map(const char* key, const std::function<void(MapReader&)>& read) {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) return;
  MapReader inner(node, path_ + key + ".", problems_);
  read(inner);
  inner.finish();
}

void MapReader::maps(const char* key, const std::function<void(MapReader&)>& read) {
  const YAML::Node node = find(key);
  if (!node.IsDefined()) return;
  if (!node.IsSequence() || node.size() == 0)
    return problems_.add(node, path_ + key, "expected a list of maps");
  for (std::size_t k = 0; k < node.size(); ++k) {
    MapReader inner(node[k], path_ + key + "[" + std::to_string(k) + "].", problems_);
    read(inner);
    inner.finish();
  }
}

void MapReader::required(const char* key) {
  if (map_.IsMap() && !map_[key].IsDefined()) problems_.add(map_, path_ + key, "is missing");
}

void MapReader::finish() {
  if (!map_.IsMap()) return;
  std::set<std::string> seen;
  for (const auto& entry : map_) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "";
    if (!seen.insert(key).second) problems_.add(entry.first, path_ + key, "is given twice");
    if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
    problems_.add(entry.first, path_ + key, "unknown key, expected one of " + joined(known_));
  }
}

}  // namespace facet
