#include "experiment/policy_reader.hpp"

#include "experiment/section_reader.hpp"
#include "experiment/yaml_reader.hpp"
#include "pipeline/stage_id.hpp"
#include "score/metrics.hpp"

namespace facet {

enum class RuleLevel { hard, soft };
enum class Inconclusive { ok, fail };
template <>
inline constexpr std::array<std::string_view, 3> enum_names<Better>{"higher", "lower", "same"};
template <>
inline constexpr std::array<std::string_view, 2> enum_names<RuleLevel>{"hard", "soft"};
template <>
inline constexpr std::array<std::string_view, 2> enum_names<Inconclusive>{"ok", "fail"};

namespace {

Rule read_rule(const ConfigValue& value, const std::string& where, ConfigErrors& errors,
               OriginTable& origins) {
  Rule rule;
  SectionReader reader(value, where, errors, origins);
  const FieldInfo tolerance{"", 0, 1e6, ""};
  if (value.find("better") != nullptr) reader("better", rule.better.emplace(), FieldInfo{"", 0, 0, ""});
  reader("abs", rule.abs_tolerance, tolerance);
  reader("rel", rule.rel_tolerance, tolerance);
  reader("min_n", rule.least_n, FieldInfo{"samples", 1, 1000000, ""});
  reader("exact", rule.exact, FieldInfo{"", 0, 0, ""});
  RuleLevel level = RuleLevel::hard;
  reader("level", level, FieldInfo{"", 0, 0, ""});
  rule.hard = level == RuleLevel::hard;
  reader("required", rule.required, FieldInfo{"", 0, 0, ""});
  reader.finish();
  return rule;
}

std::map<std::string, Rule> read_rules(SectionReader& document, const std::string& section,
                                       const std::vector<std::string>& known, ConfigErrors& errors,
                                       OriginTable& origins) {
  std::map<std::string, Rule> rules;
  const ConfigValue* value = document.take(section);
  if (value == nullptr) return rules;
  SectionReader reader(*value, section, errors, origins);
  for (const std::string& name : known)
    if (const ConfigValue* rule = reader.take(name))
      rules[name] = read_rule(*rule, section + '.' + name, errors, origins);
  reader.finish();
  return rules;
}

std::vector<std::string> metric_names() {
  std::vector<std::string> names{"*"};
  for (const Metric& metric : score_metrics()) names.push_back(metric.name);
  return names;
}

std::vector<std::string> time_names() {
  std::vector<std::string> names{"*", "total"};
  for (const StageName& stage : stage_names) names.emplace_back(stage.key);
  return names;
}

}  // namespace

Policy read_policy(const std::filesystem::path& file) {
  ConfigErrors errors;
  const ConfigValue document = read_yaml_file(file, errors);
  errors.throw_if_any();
  OriginTable origins;
  Policy policy;
  SectionReader reader(document, "", errors, origins);
  const ConfigValue* schema = reader.take("schema");
  if (schema == nullptr || schema->scalar != "1")
    reader.reject(schema != nullptr ? *schema : document, "schema", "1, the one version there is");
  reader("alpha", policy.alpha, FieldInfo{"", 0, 1, ""});
  Inconclusive inconclusive = Inconclusive::ok;
  reader("inconclusive", inconclusive, FieldInfo{"", 0, 0, ""});
  policy.inconclusive_fails = inconclusive == Inconclusive::fail;
  policy.accuracy = read_rules(reader, "accuracy", metric_names(), errors, origins);
  policy.latency = read_rules(reader, "latency", time_names(), errors, origins);
  reader.finish();
  errors.throw_if_any();
  return policy;
}

}  // namespace facet
