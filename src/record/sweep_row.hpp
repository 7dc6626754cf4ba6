#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace facet {

/// One value at one point of a sweep on one data set, or on its frames of one level: a row of
/// metrics/sweep.json (scores) or of timing/sweep.json (measure "total_ms", the mean over frames).
struct SweepRow {
  std::string method, base;
  std::map<std::string, std::string> settings;  ///< swept parameter -> value
  std::string dataset;
  std::string axis;             ///< what the data set varies; empty: all its frames
  std::optional<double> level;  ///< the value of that
  std::string measure;
  std::optional<double> value, lo, hi;  ///< with its 95 % interval, where there is one
  std::string reason;                   ///< why there is no value
};

std::string sweep_to_json(const std::vector<SweepRow>& rows);
/// Throws Error{data} for anything else.
std::vector<SweepRow> sweep_from_json(std::string_view text);

}  // namespace facet
