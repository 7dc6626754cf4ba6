// datasets/README.md says what every number in metrics/summary.json means, and speaks of no other.
#include <fstream>
#include <gtest/gtest.h>
#include <set>
#include <sstream>

#include "score/summary.hpp"

namespace facet {
namespace {

/// The section "## Metrics" of the file.
std::string metrics_section() {
  std::ifstream file(FACET_METRIC_DOCS);
  std::stringstream text;
  text << file.rdbuf();
  const std::string all = text.str();
  const auto from = all.find("\n## Metrics\n");
  if (from == std::string::npos) return {};
  const auto to = all.find("\n## ", from + 1);
  return all.substr(from, to == std::string::npos ? to : to - from);
}

/// What stands between backquotes in the first cells of its tables.
std::set<std::string> documented_names() {
  std::set<std::string> names;
  std::istringstream section(metrics_section());
  for (std::string line; std::getline(section, line);) {
    if (!line.starts_with("| `")) continue;
    std::istringstream cell(line.substr(1, line.find('|', 1) - 1));
    std::string between, name;
    while (std::getline(cell, between, '`') && std::getline(cell, name, '`')) names.insert(name);
  }
  return names;
}

std::set<std::string> known_names() {
  std::set<std::string> names;
  const ScoreSummary summary = summarise_scores({});
  for (const MetricSummary& metric : summary.metrics) names.insert(metric.name);
  for (const ErrorSummary& error : summary.errors) names.insert(error.name);
  for (const CurveSummary& curve : summary.curves) names.insert(curve.name);
  return names;
}

TEST(MetricDocs, EveryMetricErrorAndCurveIsInATable) {
  const std::set<std::string> documented = documented_names();
  ASSERT_FALSE(documented.empty()) << FACET_METRIC_DOCS;
  for (const std::string& name : known_names()) EXPECT_TRUE(documented.contains(name)) << name;
}

TEST(MetricDocs, TheTablesNameNothingElse) {
  const std::set<std::string> known = known_names();
  for (const std::string& name : documented_names()) EXPECT_TRUE(known.contains(name)) << name;
}

}  // namespace
}  // namespace facet
