#include "study/ablation_plan.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "core/error.hpp"
#include "study/switches.hpp"

namespace facet {
namespace {

/// Which switches are on, in the order of AblationOptions::switches.
using Setting = std::vector<bool>;

class AblationPlanner {
 public:
  AblationPlanner(const AblationOptions& options, const MethodSpec& base, AblationPlan& plan)
      : options_(options), base_(base), plan_(plan), n_(options.switches.size()) {}

  void add() {
    for (std::size_t i = 0; i < n_; ++i) {
      AblationComparison comparison{options_.design, base_.name,      options_.switches[i], {}, "",
                                    false,           options_.metrics};
      comparison.sequences_only = switch_at(i).sequences_only;
      std::string reason;
      for (const Setting& with : settings_with(i)) {
        Setting without = with;
        without[i] = false;
        if (reason = inert_because(i, with, without); !reason.empty()) continue;
        const std::string on = method_for(with);
        comparison.pairs.emplace_back(on, method_for(without));
      }
      if (comparison.pairs.empty()) comparison.not_applicable = reason;
      plan_.comparisons.push_back(std::move(comparison));
    }
  }

 private:
  const AblationSwitch& switch_at(std::size_t i) const { return *find_switch(options_.switches[i]); }

  /// The settings with switch i on that are compared with the same without it.
  std::vector<Setting> settings_with(std::size_t i) const {
    switch (options_.design) {
      case AblationDesign::leave_one_out:
        return {Setting(n_, true)};
      case AblationDesign::one_in: {
        Setting only(n_, false);
        only[i] = true;
        return {only};
      }
      case AblationDesign::cumulative: {
        Setting so_far(n_, false);
        std::fill(so_far.begin(), so_far.begin() + static_cast<std::ptrdiff_t>(i) + 1, true);
        return {so_far};
      }
      default:
        return every_subset_with(i);
    }
  }

  std::vector<Setting> every_subset_with(std::size_t i) const {
    std::vector<Setting> subsets;
    for (unsigned bits = 0; bits < 1u << n_; ++bits) {
      if ((bits >> i & 1u) == 0) continue;
      Setting subset(n_, false);
      for (std::size_t k = 0; k < n_; ++k) subset[k] = (bits >> k & 1u) != 0;
      subsets.push_back(std::move(subset));
    }
    return subsets;
  }

  PipelineParams params_of(const Setting& setting) const {
    PipelineParams params = base_.params;
    for (std::size_t k = 0; k < n_; ++k)
      if (!setting[k]) switch_at(k).turn_off(params);
    return params;
  }

  std::string inert_because(std::size_t i, const Setting& with, const Setting& without) const {
    const PipelineParams on = params_of(with), off = params_of(without);
    if (same_params(on, off)) return fmt::format("off in method {} already", base_.name);
    return switch_at(i).inert_because(on);
  }

  /// Short names of the settings: "paper.all", "paper.none", "paper.no-fill", "paper.fill-wiener".
  std::string name_of(const Setting& setting) const {
    const auto on = static_cast<std::size_t>(std::count(setting.begin(), setting.end(), true));
    if (on == n_) return base_.name + ".all";
    if (on == 0) return base_.name + ".none";
    const bool all_but_one = on + 1 == n_ && options_.design == AblationDesign::leave_one_out;
    std::string names;
    for (std::size_t k = 0; k < n_; ++k)
      if (setting[k] != all_but_one) names += (names.empty() ? "" : "-") + options_.switches[k];
    return fmt::format("{}.{}{}", base_.name, all_but_one ? "no-" : "", names);
  }

  /// The method of a setting, added to the plan unless one computes the same.
  std::string method_for(const Setting& setting) {
    MethodSpec variant = base_;
    variant.params = params_of(setting);
    const auto same = std::find_if(plan_.methods.begin(), plan_.methods.end(), [&](const MethodSpec& m) {
      return m.kind == variant.kind && same_params(m.params, variant.params);
    });
    if (same != plan_.methods.end()) return same->name;
    variant.name = free_name(name_of(setting));
    validate(variant.params);
    plan_.methods.push_back(variant);
    return variant.name;
  }

  /// Two designs over one base may spell different methods alike.
  std::string free_name(const std::string& wanted) const {
    const auto is_taken = [&](const std::string& name) {
      return std::any_of(plan_.methods.begin(), plan_.methods.end(),
                         [&](const MethodSpec& m) { return m.name == name; });
    };
    std::string name = wanted;
    for (int i = 2; is_taken(name); ++i) name = fmt::format("{}.{}", wanted, i);
    return name;
  }

  const AblationOptions& options_;
  const MethodSpec& base_;
  AblationPlan& plan_;
  std::size_t n_;
};

[[noreturn]] void reject(const std::string& message) {
  throw Error(ErrorKind::config, "ablation: " + message);
}

const MethodSpec& base_of(const AblationOptions& options, const std::vector<MethodSpec>& methods) {
  const auto base = std::find_if(methods.begin(), methods.end(),
                                 [&](const MethodSpec& m) { return m.name == options.base; });
  if (base == methods.end())
    reject(fmt::format("base {}: no method of the experiment has this name", options.base));
  if (base->kind != "pipeline")
    reject(fmt::format("base {}: kind {} has no switches", options.base, base->kind));
  return *base;
}

}  // namespace

AblationPlan plan_ablations(const std::vector<AblationOptions>& ablations,
                            const std::vector<MethodSpec>& methods) {
  AblationPlan plan;
  for (const AblationOptions& options : ablations) {
    if (options.switches.empty()) reject("no switch is named");
    if (options.design == AblationDesign::factorial && options.switches.size() > most_factorial_switches)
      reject(fmt::format("design factorial takes {} switches at most, {} are named", most_factorial_switches,
                         options.switches.size()));
    AblationPlanner(options, base_of(options, methods), plan).add();
  }
  return plan;
}

}  // namespace facet
