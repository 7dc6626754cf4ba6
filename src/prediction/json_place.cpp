#include "prediction/json_place.hpp"

#include <algorithm>
#include <limits>

namespace facet {

void JsonPlace::only(std::initializer_list<std::string_view> names) const {
  if (!value_.is_object()) fail("expected an object");
  for (const auto& [name, value] : value_.items())
    if (std::find(names.begin(), names.end(), name) == names.end()) fail("unknown name '" + name + "'");
}

JsonPlace JsonPlace::at(std::string_view name) const {
  if (!value_.is_object() || !has(name)) fail("'" + std::string(name) + "' is missing");
  return {value_.at(std::string(name)), file_, place_ + (place_.empty() ? "" : ".") + std::string(name)};
}

std::vector<JsonPlace> JsonPlace::items() const {
  if (!value_.is_array()) fail("expected a list");
  std::vector<JsonPlace> places;
  for (std::size_t i = 0; i < value_.size(); ++i)
    places.emplace_back(value_[i], file_, place_ + "[" + std::to_string(i) + "]");
  return places;
}

int JsonPlace::integer() const {
  if (!value_.is_number_integer()) fail("expected an integer");
  const auto value = value_.get<std::int64_t>();
  if (value < std::numeric_limits<int>::min() || value > std::numeric_limits<int>::max())
    fail("is out of range");
  return static_cast<int>(value);
}

float JsonPlace::number() const {
  if (!value_.is_number()) fail("expected a number");
  return value_.get<float>();
}

bool JsonPlace::flag() const {
  if (!value_.is_boolean()) fail("expected true or false");
  return value_.get<bool>();
}

std::string JsonPlace::text() const {
  if (!value_.is_string()) fail("expected a text");
  return value_.get<std::string>();
}

}  // namespace facet
