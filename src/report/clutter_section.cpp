#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "report/frame_points.hpp"
#include "report/run_report.hpp"
#include "report/statistics.hpp"

namespace facet {
namespace {

/// More frames than this are shown as means over those of equal clutter.
constexpr std::size_t most_single_frames = 150;

/// A quantity of the paper's Figure 12, over how much there is in a scene.
struct Quantity {
  const char *name, *unit, *slope_unit;
  std::optional<double> (*value)(const FramePoint&);
  std::optional<double> highest;
};

std::optional<double> in_percent(const FramePoint& point, const char* metric) {
  const std::optional<double> share = point.score(metric);
  return share ? std::optional(100 * *share) : share;
}

const Quantity quantities[]{
    {"Surface recall", "%", "points", [](const FramePoint& p) { return in_percent(p, "surface_recall_0.5"); },
     100},
    {"Surface F1", "%", "points", [](const FramePoint& p) { return in_percent(p, "surface_f1_0.5"); }, 100},
    {"surface_count_ratio", "1", "", [](const FramePoint& p) { return p.score("surface_count_ratio"); }, {}},
    {"Segmentation time", "ms", "ms", [](const FramePoint& p) { return p.segmentation_ms; }, {}},
};

struct ClutterAxis {
  const char *name, *one;
  double FramePoint::*value;
};
constexpr ClutterAxis axes[]{{"surfaces", "surface", &FramePoint::surfaces},
                             {"objects", "object", &FramePoint::objects}};

struct Values {
  std::vector<double> x, y;
  std::vector<std::string> frames;
};

Values values_of(const std::vector<FramePoint>& points, const ClutterAxis& axis, const Quantity& quantity) {
  Values values;
  for (const FramePoint& point : points) {
    const std::optional<double> y = quantity.value(point);
    // Frames without truth have no known number of objects.
    if (!y || (axis.value == &FramePoint::objects && !point.row->score)) continue;
    values.x.push_back(point.*axis.value);
    values.y.push_back(*y);
    values.frames.push_back(point.row->frame);
  }
  return values;
}

std::vector<ChartPoint> single_points(const Values& values, const std::string& method,
                                      const Quantity& quantity, const ClutterAxis& axis) {
  std::vector<ChartPoint> points;
  for (std::size_t i = 0; i < values.x.size(); ++i)
    points.push_back({values.x[i],
                      values.y[i],
                      {},
                      {},
                      fmt::format("{} ({}): {:.4g} {} at {:.0f} {}", values.frames[i], method, values.y[i],
                                  quantity.unit, values.x[i], axis.name)});
  return points;
}

std::vector<ChartPoint> mean_points(const Values& values, const std::string& method, const Quantity& quantity,
                                    const ClutterAxis& axis) {
  std::map<double, std::vector<double>> groups;
  for (std::size_t i = 0; i < values.x.size(); ++i) groups[values.x[i]].push_back(values.y[i]);
  std::vector<ChartPoint> points;
  for (const auto& [x, y] : groups) {
    ChartPoint point{x, mean_of(y), {}, {}, {}};
    const int n = static_cast<int>(y.size());
    if (n > 1) {
      const double half = student_t_975(n - 1) * deviation_of(y) / std::sqrt(n);
      point.lo = point.y - half;
      point.hi = std::min(point.y + half, quantity.highest.value_or(std::numeric_limits<double>::infinity()));
    }
    point.hover = fmt::format("{}: mean {:.4g} {} at {:.0f} {}, n = {}", method, point.y, quantity.unit, x,
                              axis.name, n);
    points.push_back(std::move(point));
  }
  return points;
}

std::string slope_text(const std::optional<LineFit>& fit) {
  if (!fit) return "n/a";
  return fmt::format("{:+.3f} [{:+.3f}, {:+.3f}], n = {}", fit->slope, fit->slope_low, fit->slope_high,
                     fit->n);
}

void add_series(XyChart& chart, const Values& values, const std::string& method, int color,
                const Quantity& quantity, const ClutterAxis& axis) {
  ChartSeries points;
  points.color = color;
  points.points = values.x.size() > most_single_frames ? mean_points(values, method, quantity, axis)
                                                       : single_points(values, method, quantity, axis);
  const std::optional<LineFit> fit = fit_line(values.x, values.y);
  points.name = fmt::format("{}: slope {}", method, slope_text(fit));
  if (fit) {
    const auto [low, high] = std::minmax_element(values.x.begin(), values.x.end());
    ChartSeries line{"", color, true, false, {}};
    for (const double x : {*low, *high})
      line.points.push_back({x, fit->intercept + fit->slope * x, {}, {}, {}});
    chart.series.push_back(std::move(line));
  }
  chart.series.push_back(std::move(points));
}

using MethodPoints = std::vector<std::pair<std::string, std::vector<FramePoint>>>;

/// One chart, and a row of slopes; nothing where no method has values.
void add_quantity(ReportSection& section, ReportTable& slopes, const std::string& dataset,
                  const MethodPoints& methods, const Quantity& quantity, const ClutterAxis& axis) {
  XyChart chart;
  chart.x = {fmt::format("{} in the scene", axis.name), {}, {}};
  chart.y = {fmt::format("{} [{}]", quantity.name, quantity.unit), 0, quantity.highest};
  std::vector<std::string> row{fmt::format("{} [{} per {}]", quantity.name,
                                           *quantity.slope_unit ? quantity.slope_unit : "1", axis.one)};
  int color = 0;
  bool any = false;
  for (const auto& [method, points] : methods) {
    const Values values = values_of(points, axis, quantity);
    if (!values.x.empty()) add_series(chart, values, method, color, quantity, axis);
    any = any || !values.x.empty();
    row.push_back(slope_text(fit_line(values.x, values.y)));
    ++color;
  }
  if (!any) return;
  section.charts.push_back({fmt::format("{} over {}, {}", quantity.name, axis.name, dataset), chart});
  slopes.rows.push_back(std::move(row));
}

}  // namespace

ReportSection clutter_section(const RunRecord& run) {
  ReportSection section;
  section.title = "Clutter";
  section.on_console = false;
  for (const std::string& dataset : run.manifest.datasets) {
    MethodPoints methods;
    for (const std::string& method : run.manifest.methods)
      methods.emplace_back(method, frame_points(run, dataset, method));
    ReportTable slopes;
    slopes.caption = fmt::format("Slopes with 95 % intervals on {}", dataset);
    slopes.header = {"quantity"};
    for (const std::string& method : run.manifest.methods) slopes.header.push_back(method);
    for (const Quantity& quantity : quantities)
      for (const ClutterAxis& axis : axes) add_quantity(section, slopes, dataset, methods, quantity, axis);
    if (!slopes.rows.empty()) section.tables.push_back(std::move(slopes));
  }
  if (section.tables.empty())
    section.paragraphs.push_back("No frame has truth or times.");
  else
    section.paragraphs.push_back(
        "The paper's Figure 12 with our definitions. Points are frames, or means over frames of equal "
        "clutter "
        "with 95 % intervals; lines are least squares over frames, with the 95 % interval of the slope. "
        "surface_count_ratio is the accuracy as the paper words it: regions counted on surfaces over "
        "surfaces "
        "there. Segmentation time is the total without poses and grasps.");
  return section;
}

}  // namespace facet
