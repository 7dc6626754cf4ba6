#include "experiment/config_errors.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>
#include <tuple>

#include "core/error.hpp"

namespace facet {
namespace {

/// Levenshtein distance.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i] != b[j]);
      diagonal = row[j + 1];
      row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, substituted});
    }
  }
  return row.back();
}

std::string_view last_part(std::string_view dotted) {
  return dotted.substr(dotted.rfind('.') + 1);
}

}  // namespace

void ConfigErrors::add(const Origin& origin, std::string_view path, const std::string& value,
                       const std::string& expected, const std::string& suggestion) {
  std::string message = fmt::format("{}: {}: value {}: expected {}", origin.text(), path, value, expected);
  if (!suggestion.empty()) message += fmt::format("; did you mean \"{}\"?", suggestion);
  messages_.push_back({origin, std::move(message)});
}

void ConfigErrors::add(const Origin& origin, const std::string& message) {
  messages_.push_back({origin, fmt::format("{}: {}", origin.text(), message)});
}

void ConfigErrors::throw_if_any() const {
  if (messages_.empty()) return;
  std::vector<Message> sorted = messages_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Message& a, const Message& b) {
    return std::tie(a.origin.source, a.origin.line, a.origin.column) <
           std::tie(b.origin.source, b.origin.line, b.origin.column);
  });
  std::string text = sorted.size() == 1 ? "the configuration has an error"
                                        : fmt::format("the configuration has {} errors", sorted.size());
  for (const Message& message : sorted) text += '\n' + message.text;
  throw Error(ErrorKind::config, text);
}

std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates) {
  std::string best;
  std::size_t best_distance = std::max<std::size_t>(2, name.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    // A key in the wrong section ("crease.radius_px") is near to the key whose last part is the same.
    const bool same_leaf = name.find('.') != name.npos && last_part(name) == last_part(candidate);
    const std::size_t distance = same_leaf ? 1 : edit_distance(name, candidate);
    if (distance < best_distance) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

}  // namespace facet
