#pragma once

#include <map>
#include <string>
#include <vector>

#include "experiment/experiment.hpp"

namespace facet {

/// A method of a sweep and the values it stands for.
struct SweepPoint {
  MethodSpec method;
  std::string base;                             ///< the method that it comes from
  std::map<std::string, std::string> settings;  ///< swept parameter -> value, as text
};

/// Every combination of the swept values over every pipeline of the experiment: "BASE.wiener.window_px-3".
/// Throws Error{config} where parameters contradict each other at a point, or nothing can be swept.
std::vector<SweepPoint> plan_sweep(const Experiment& experiment);

}  // namespace facet
