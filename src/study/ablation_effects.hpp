#pragma once

#include "record/ablation_row.hpp"
#include "record/run_record.hpp"
#include "score/intervals.hpp"
#include "study/ablation_plan.hpp"

namespace facet {

/// What every switch is worth by every metric, paired per frame, with Holm's correction within each design
/// and data set. A comparison that cannot differ gives rows that say why.
std::vector<AblationRow> ablation_effects(const AblationPlan& plan, const std::vector<FrameRow>& rows,
                                          const std::vector<std::string>& datasets,
                                          const BootstrapOptions& options = {});

/// And what it costs: differences of the total time per frame [ms], measure "total_ms". Nothing where the run
/// was not timed.
std::vector<AblationRow> ablation_costs(const AblationPlan& plan, const RunRecord& run,
                                        const BootstrapOptions& options = {});

/// Holm 1979: adjusted p values, in the order given.
std::vector<double> holm(const std::vector<double>& p);

}  // namespace facet
