#pragma once

#include <string>
#include <utility>
#include <vector>

#include "method/method_spec.hpp"

namespace facet {

/// Which combinations of the switches run. leave_one_out: all on, and all but one. one_in: all off, and one
/// on. cumulative: all off, then one more on at a time, in their order (figure 5). factorial: every subset.
enum class AblationDesign { leave_one_out, one_in, cumulative, factorial };

/// One entry of an experiment's `ablation`.
struct AblationOptions {
  AblationDesign design = AblationDesign::leave_one_out;
  std::string base = "default";       ///< method whose switches are turned
  std::vector<std::string> switches;  ///< names of ablation_switches()
  std::vector<std::string> metrics{"surface_recall_0.5", "surface_precision_0.5", "edge_recall_all_6px",
                                   "edge_precision_6px"};
};

/// What a switch is worth: the mean over pairs of methods of the value with it less the value without it.
struct AblationComparison {
  AblationDesign design = AblationDesign::leave_one_out;
  std::string base;
  std::string switch_name;
  std::vector<std::pair<std::string, std::string>> pairs{};  ///< names of the methods with and without it
  std::string not_applicable{};                              ///< why it cannot have an effect; no pairs then
  bool sequences_only = false;
  std::vector<std::string> metrics{};
};

struct AblationPlan {
  std::vector<MethodSpec> methods;  ///< that run, each once
  std::vector<AblationComparison> comparisons;
};

/// Most switches of a factorial design.
inline constexpr std::size_t most_factorial_switches = 5;

/// Expands the ablations of an experiment. Variants that by their parameters compute the same are one method.
/// Throws Error{config} where a base is no method, or no pipeline, where no switch is named, or too many for
/// a factorial design.
AblationPlan plan_ablations(const std::vector<AblationOptions>& ablations,
                            const std::vector<MethodSpec>& methods);

}  // namespace facet
