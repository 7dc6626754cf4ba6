#pragma once

#include "record/run_record.hpp"
#include "report/document.hpp"

namespace facet {

/// What a run measured: summary, detection in the layout of the paper's Table 2, times in the layout of the
/// paper's Table 3, surfaces found per frame, failures, pictures, timing details, provenance.
Report make_run_report(const RunRecord& run);

// Its sections, one file each.
ReportSection detection_section(const RunRecord& run);
ReportSection score_detail_section(const RunRecord& run);
ReportSection timing_section(const RunRecord& run);
ReportSection timing_detail_section(const RunRecord& run);
ReportSection surfaces_section(const RunRecord& run);
ReportSection failures_section(const RunRecord& run);

}  // namespace facet
