#pragma once

#include <map>
#include <string>

#include "compare/verdict.hpp"

namespace facet {

enum class MeasuredKind { accuracy, latency };

/// What a comparison judges, and how: a rule per metric and per stage time. The name "*" stands for every one
/// that has no rule of its own; what no rule covers is not judged.
struct Policy {
  double alpha = 0.05;              ///< level of the tests
  bool inconclusive_fails = false;  ///< inconclusive is not measured well enough
  std::map<std::string, Rule> accuracy;
  std::map<std::string, Rule> latency;  ///< keys of stages, and "total"

  /// Null where nothing is asked of it.
  const Rule* find(MeasuredKind kind, const std::string& name) const;
};

/// What `facet compare` asks: any change of a score, a change of 5 % of a time.
Policy comparing_policy();

}  // namespace facet
