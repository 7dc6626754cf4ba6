#pragma once

#include "compare/gate.hpp"
#include "report/document.hpp"

namespace facet {

/// What compares what, for titles.
struct ComparedNames {
  std::string before, after;
};

/// The decision, what is not ok, and every value.
Report make_comparison_report(const Comparison& comparison, const GateDecision& decision,
                              const ComparedNames& names);

/// The same as JSON, schema_version 1: decision, values, vanished, notes.
std::string comparison_json(const Comparison& comparison, const GateDecision& decision,
                            const ComparedNames& names);

/// JUnit: a suite per method and data set, a test case per value.
std::string junit_xml(const Comparison& comparison, const GateDecision& decision);

/// Workflow commands of GitHub Actions: ::error for what fails, ::warning for the rest.
std::string github_annotations(const GateDecision& decision);

}  // namespace facet
