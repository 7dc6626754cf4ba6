#include "pipeline/params.hpp"

#include <cmath>
#include <string>
#include <type_traits>

#include "core/error.hpp"
#include "pipeline/enum_names.hpp"
#include "pipeline/params_fields.hpp"

namespace facet {
namespace {

[[noreturn]] void reject(std::string_view key, const std::string& rule, const std::string& value) {
  throw Error(ErrorKind::config, std::string(key) + ": " + rule + ", got " + value);
}

struct RangeCheck {
  template <class T>
  void operator()(std::string_view key, const T& value, const FieldInfo& info) const {
    if constexpr (std::is_same_v<T, int> || std::is_same_v<T, float>) {
      const double number = value;
      if (!(number >= info.min && number <= info.max))
        reject(key, "must lie in [" + std::to_string(info.min) + ", " + std::to_string(info.max) + "]",
               std::to_string(value));
    }
    if constexpr (std::is_same_v<T, int>) {
      if (info.odd && value % 2 == 0) reject(key, "must be odd", std::to_string(value));
    }
  }
};

}  // namespace

void validate(const PipelineParams& params) {
  visit_fields(params, RangeCheck{});
  if (params.dd.low_per_px > params.dd.high_per_px)
    reject("dd.low_per_px", "must not exceed dd.high_per_px", std::to_string(params.dd.low_per_px));
  if (params.cd.low_deg > params.cd.high_deg)
    reject("cd.low_deg", "must not exceed cd.high_deg", std::to_string(params.cd.low_deg));
  if (params.cd.closure == CreaseClosure::basins && params.cd.mode != CreaseMode::normals)
    reject("cd.closure", "basins needs cd.mode: normals", std::string(enum_name(params.cd.mode)));
  if (params.morphology.small_element_px >= params.morphology.large_element_px)
    reject("morphology.small_element_px", "must be smaller than morphology.large_element_px",
           std::to_string(params.morphology.small_element_px));
}

}  // namespace facet
