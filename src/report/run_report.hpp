#pragma once

#include "record/run_record.hpp"
#include "report/document.hpp"

namespace facet {

/// What a run measured: summary, detection in the layout of the paper's Table 2, methods side by side,
/// stability over sequences, times in the layout of the paper's Table 3, its Figure 12, curves, invariance,
/// surfaces found per frame, failures, pictures, details, provenance.
Report make_run_report(const RunRecord& run);

// Its sections, one file each.
ReportSection summary_section(const RunRecord& run);
ReportSection detection_section(const RunRecord& run);
/// Of runs of two methods or more: their scores with paired differences, and accuracy against latency.
ReportSection methods_section(const RunRecord& run);
/// The frames that the methods disagree on.
ReportSection disputed_section(const RunRecord& run);
ReportSection score_detail_section(const RunRecord& run);
ReportSection ablation_section(const RunRecord& run);
ReportSection sweep_section(const RunRecord& run);
ReportSection timing_section(const RunRecord& run);
ReportSection timing_detail_section(const RunRecord& run);
ReportSection sequence_section(const RunRecord& run);
ReportSection clutter_section(const RunRecord& run);
ReportSection curve_section(const RunRecord& run);
ReportSection level_section(const RunRecord& run);
ReportSection surfaces_section(const RunRecord& run);
ReportSection failures_section(const RunRecord& run);

/// The paper's Table 2 of a data set, one row per frame, and its Table 3 with one row per method, as they
/// are laid out there; without rows where there is nothing to show.
ReportTable table2_of_paper(const RunRecord& run, const std::string& dataset);
ReportTable table3_of_paper(const RunRecord& run, const std::string& dataset);

}  // namespace facet
