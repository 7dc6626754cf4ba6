#include "compare/policy.hpp"

namespace facet {

const Rule* Policy::find(MeasuredKind kind, const std::string& name) const {
  const std::map<std::string, Rule>& rules = kind == MeasuredKind::accuracy ? accuracy : latency;
  auto found = rules.find(name);
  if (found == rules.end()) found = rules.find("*");
  return found == rules.end() ? nullptr : &found->second;
}

Policy comparing_policy() {
  Policy policy;
  policy.accuracy["*"] = Rule{.required = true};
  policy.latency["*"] = Rule{.abs_tolerance = 0.05, .rel_tolerance = 0.05, .required = true};
  return policy;
}

}  // namespace facet
