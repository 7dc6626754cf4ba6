#include <fmt/format.h>

#include "report/run_report.hpp"
#include "score/intervals.hpp"
#include "score/metrics.hpp"

namespace facet {
namespace {

struct CurveChart {
  const char *curve, *title, *x_label, *y_label;
};
constexpr CurveChart curve_charts[]{
    {"hoover_correct", "Correct surfaces over the tolerance of Hoover", "tolerance T [1]",
     "correctly segmented [%]"},
    {"edge_recall_graspable", "Recall of graspable edges over the tolerance", "tolerance [px]",
     "detected [%]"},
    {"edge_recall_all", "Recall of all edges over the tolerance", "tolerance [px]", "detected [%]"},
    {"edge_precision", "Precision of edge pixels over the tolerance", "tolerance [px]",
     "near a true edge [%]"},
};

/// Pooled tallies of a method; empty where no frame has what the curve needs.
std::vector<Tally> pooled(const RunRecord& run, const std::string& dataset, const std::string& method,
                          const MetricCurve& curve) {
  std::vector<Tally> sums;
  bool predicted = false;
  for (const FrameRow& row : run.frames) {
    if (row.dataset != dataset || row.method != method || !row.score) continue;
    const AnnotatedParts& has = row.score->annotated;
    if ((curve.needs_truth.surfaces && !has.surfaces) || (curve.needs_truth.edges && !has.edges)) continue;
    predicted = predicted || !curve.needs_prediction.edges || row.score->predicted.edges;
    const std::vector<Tally> tallies = curve.tallies(*row.score);
    sums.resize(tallies.size());
    for (std::size_t i = 0; i < tallies.size(); ++i) {
      sums[i].hit += tallies[i].hit;
      sums[i].n += tallies[i].n;
    }
  }
  return predicted ? sums : std::vector<Tally>();
}

ChartSeries series_of(const std::string& method, int color, const MetricCurve& curve,
                      const std::vector<Tally>& tallies) {
  ChartSeries series{method, color, true, tallies.size() <= 12, {}};
  for (std::size_t i = 0; i < tallies.size(); ++i) {
    const Tally& t = tallies[i];
    if (t.n == 0) continue;
    ChartPoint point{curve.thresholds[i], 100.0 * t.hit / t.n, {}, {}, {}};
    // Pixels of an edge depend on each other: no interval for their shares.
    if (curve.name != "edge_precision") {
      const Interval interval = wilson_interval(t.hit, t.n);
      point.lo = 100 * interval.lo;
      point.hi = 100 * interval.hi;
    }
    point.hover = fmt::format("{} at {}: {:.1f} % ({}/{})", method, curve.thresholds[i], point.y, t.hit, t.n);
    series.points.push_back(std::move(point));
  }
  return series;
}

std::optional<ReportChart> chart_of(const RunRecord& run, const std::string& dataset,
                                    const CurveChart& chart) {
  XyChart body{{chart.x_label, {}, {}}, {chart.y_label, 0, 100}, {}};
  int color = 0;
  for (const MetricCurve& curve : score_curves()) {
    if (curve.name != chart.curve) continue;
    for (const std::string& method : run.manifest.methods) {
      ChartSeries series = series_of(method, color++, curve, pooled(run, dataset, method, curve));
      if (!series.points.empty()) body.series.push_back(std::move(series));
    }
  }
  if (body.series.empty()) return std::nullopt;
  return ReportChart{fmt::format("{}, {}", chart.title, dataset), std::move(body), {}};
}

}  // namespace

ReportSection curve_section(const RunRecord& run) {
  ReportSection section;
  section.title = "Curves";
  section.on_console = false;
  for (const std::string& dataset : run.manifest.datasets)
    for (const CurveChart& chart : curve_charts)
      if (auto drawn = chart_of(run, dataset, chart)) section.charts.push_back(std::move(*drawn));
  section.paragraphs.push_back(
      section.charts.empty() ? "Not scored: no frame has truth."
                             : "How scores depend on how strict they are, pooled over frames, with Wilson "
                               "95 % intervals. The tables use T = 0.8, and 6 px at 640 x 480.");
  return section;
}

}  // namespace facet
