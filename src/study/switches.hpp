#pragma once

#include <span>
#include <string>
#include <string_view>

#include "pipeline/params.hpp"

namespace facet {

/// A step of the pipeline that an ablation turns off: a step of the paper, or one that this implementation
/// put in a paper step's place, whose "off" is the paper's own choice.
struct AblationSwitch {
  std::string_view name;
  std::string_view doc;  ///< what it does, and what is done without it
  void (*turn_off)(PipelineParams&);
  /// What must hold for it to do anything; empty text where it does.
  std::string (*inert_because)(const PipelineParams&);
  bool sequences_only = false;  ///< nothing happens on single frames
};

/// THE table, in the order of the pipeline: steps of the paper first, then repairs.
std::span<const AblationSwitch> ablation_switches();
/// Null for an unknown name.
const AblationSwitch* find_switch(std::string_view name);

/// Whether two methods compute the same by their parameters.
bool same_params(const PipelineParams& a, const PipelineParams& b);

}  // namespace facet
