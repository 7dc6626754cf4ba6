#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace facet {

/// JSON with the members in the order of writing and floats printed as the shortest text that reads back the
/// same.
using FloatJson = nlohmann::basic_json<nlohmann::ordered_map, std::vector, std::string, bool, std::int64_t,
                                       std::uint64_t, float>;

/// A value in a JSON file and where it stands, so that every error names its place. The accessors throw
/// Error{data} where the value is of another type. The value must outlive it.
class JsonPlace {
 public:
  JsonPlace(const FloatJson& value, std::string file, std::string place = {})
      : value_(value), file_(std::move(file)), place_(std::move(place)) {}

  [[noreturn]] void fail(const std::string& rule) const {
    throw Error(ErrorKind::data, file_ + ": " + place_ + (place_.empty() ? "" : ": ") + rule);
  }
  /// Checks that this is an object without other members than these.
  void only(std::initializer_list<std::string_view> names) const;
  bool has(std::string_view name) const { return value_.contains(name); }
  bool is_null() const { return value_.is_null(); }
  bool is_list() const { return value_.is_array(); }
  JsonPlace at(std::string_view name) const;  ///< a required member
  std::vector<JsonPlace> items() const;
  int integer() const;
  float number() const;
  bool flag() const;
  std::string text() const;
  template <std::size_t n>
  std::array<float, n> numbers() const {
    const auto list = items();
    if (list.size() != n) fail("expected " + std::to_string(n) + " numbers");
    std::array<float, n> values{};
    for (std::size_t i = 0; i < n; ++i) values[i] = list[i].number();
    return values;
  }

 private:
  const FloatJson& value_;
  std::string file_, place_;
};

}  // namespace facet
