#include "experiment/sweep_plan.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "experiment/typed_value.hpp"

namespace facet {
namespace {

/// Sets one parameter by its key; the text was checked when the experiment was read.
void set_parameter(PipelineParams& params, const std::string& key, const std::string& text) {
  ConfigValue value;
  value.kind = ConfigValue::Kind::scalar;
  value.scalar = text;
  visit_fields(params, [&](std::string_view name, auto& member, const FieldInfo&) {
    if (name == key && !read_typed(value, member))
      throw Error(ErrorKind::internal, fmt::format("sweep: {} cannot be {}", key, text));
  });
}

/// The points so far, each with every value of one more axis.
std::vector<SweepPoint> with_axis(const std::vector<SweepPoint>& points, const SweepAxis& axis) {
  std::vector<SweepPoint> out;
  for (const SweepPoint& point : points) {
    for (const std::string& value : axis.values) {
      SweepPoint next = point;
      set_parameter(next.method.params, axis.parameter, value);
      next.method.name += fmt::format(".{}-{}", axis.parameter, value);
      next.settings[axis.parameter] = value;
      out.push_back(std::move(next));
    }
  }
  return out;
}

}  // namespace

std::vector<SweepPoint> plan_sweep(const Experiment& experiment) {
  std::vector<SweepPoint> points;
  for (const MethodSpec& method : experiment.methods)
    if (method.kind == "pipeline") points.push_back({method, method.name, {}});
  if (points.empty()) throw Error(ErrorKind::config, "sweep: no method of kind pipeline has parameters");
  for (const SweepAxis& axis : experiment.sweep) points = with_axis(points, axis);
  for (const SweepPoint& point : points) {
    try {
      validate(point.method.params);
    } catch (const Error& e) {
      throw Error(ErrorKind::config, fmt::format("sweep: {}: {}", point.method.name, e.what()));
    }
  }
  return points;
}

}  // namespace facet
