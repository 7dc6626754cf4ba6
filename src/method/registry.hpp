#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "core/sensor.hpp"
#include "method/method.hpp"
#include "method/method_spec.hpp"

namespace facet {

/// What a method is told about the data and the machine.
struct MethodContext {
  Sensor dataset_sensor = Sensor::kinect_v1;  ///< stands in where the parameters say `auto`
  std::uint64_t seed = 1;
  int threads = 1;  ///< inside one frame
};

/// One kind of method.
struct MethodKind {
  std::string_view name;
  std::string_view doc;  ///< one line
  bool computes_here;    ///< its times are measured; otherwise it has none
  std::unique_ptr<Method> (*make)(const MethodSpec& spec, const MethodContext& context);
};

/// Every kind, in the order they are listed.
std::span<const MethodKind> method_kinds();

/// Throws Error{config} where no kind has that name.
const MethodKind& find_method_kind(const MethodSpec& spec);

/// Throws Error{config} for an unknown kind or a parameter out of range.
std::unique_ptr<Method> make_method(const MethodSpec& spec, const MethodContext& context);

}  // namespace facet
