#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiment/config_value.hpp"

namespace facet {

/// Collects every error of a configuration, so that all of them are reported at once.
class ConfigErrors {
 public:
  /// Adds "origin: path: value V: expected E" and, where a known name lies near, "; did you mean N?".
  void add(const Origin& origin, std::string_view path, const std::string& value, const std::string& expected,
           const std::string& suggestion = {});
  void add(const Origin& origin, const std::string& message);
  bool empty() const { return messages_.empty(); }
  /// Throws Error{config} with one line per error, in the order of the files' lines; does nothing without
  /// any.
  void throw_if_any() const;

 private:
  struct Message {
    Origin origin;
    std::string text;
  };
  std::vector<Message> messages_;
};

/// The candidate with the least edit distance to `name`; empty where none is near.
std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates);

}  // namespace facet
