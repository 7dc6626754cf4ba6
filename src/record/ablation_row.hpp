#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace facet {

/// What one switch is worth by one measure on one data set: a row of metrics/ablation.json (scores) or of
/// timing/ablation.json (measure "total_ms").
struct AblationRow {
  std::string design, base;  ///< "leave_one_out", "paper"
  std::string switch_name;
  std::string dataset;
  std::string measure;                  ///< a metric, or total_ms
  std::optional<double> with, without;  ///< pooled over frames, mean over the pairs of a factorial design
  std::optional<double> change;         ///< with - without
  std::optional<double> lo, hi;         ///< its 95 % interval, paired over frames
  std::optional<double> p, p_holm;  ///< of no change; corrected over the switches and metrics of the design
  int n = 0;                        ///< frames
  std::string reason;               ///< why there is no change to tell, or that no frame differs
};

std::string ablation_to_json(const std::vector<AblationRow>& rows);
/// Throws Error{data} for anything else.
std::vector<AblationRow> ablation_from_json(std::string_view text);

}  // namespace facet
