#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "report/chart.hpp"
#include "report/markup.hpp"

namespace facet {
namespace {

// In units of the view box, which a phone shows at about one pixel each.
constexpr double width = 420, left = 52, right = 20, top = 8, plot_height = 210, line_height = 17;
constexpr double range_row_height = 13, range_label_width = 118;
constexpr int color_count = 6;

std::string color_class(int color) {
  return fmt::format("c{}", color % color_count);
}

/// Linear map of an axis to the picture.
struct Scale {
  double low = 0, high = 1, from = 0, to = 1;
  bool logarithmic = false;
  double operator()(double v) const {
    const double share =
        logarithmic ? std::log(std::max(v, low) / low) / std::log(high / low) : (v - low) / (high - low);
    return from + share * (to - from);
  }
};

struct Limits {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  void add(double v) {
    low = std::min(low, v);
    high = std::max(high, v);
  }
};

/// Ticks that cover the data, or lie within the limits that the axis has.
std::vector<double> ticks_of(const ChartAxis& axis, Limits limits, int count) {
  if (!(limits.low <= limits.high)) limits = {0, 1};
  if (limits.low == limits.high) limits = {limits.low - 0.5, limits.high + 0.5};
  if (axis.logarithmic)
    return logarithmic_ticks(axis.lowest.value_or(limits.low), axis.highest.value_or(limits.high));
  std::vector<double> ticks =
      axis_ticks(axis.lowest.value_or(limits.low), axis.highest.value_or(limits.high), count);
  if (axis.lowest) std::erase_if(ticks, [&](double t) { return t < *axis.lowest - 1e-9; });
  if (axis.highest) std::erase_if(ticks, [&](double t) { return t > *axis.highest + 1e-9; });
  return ticks;
}

Scale scale_of(const ChartAxis& axis, const std::vector<double>& ticks, double from, double to) {
  return {axis.lowest.value_or(ticks.front()), axis.highest.value_or(ticks.back()), from, to,
          axis.logarithmic};
}

std::string tick_text(double value) {
  return fmt::format("{:.6g}", std::abs(value) < 1e-12 ? 0.0 : value);
}

std::string svg_open(const ReportChart& chart, double height) {
  return fmt::format("<svg class=\"chart\" viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" aria-label=\"{}\">\n",
                     width, height, escaped_markup(chart.title));
}

std::string titled(const std::string& hover, const std::string& shape) {
  return hover.empty() ? shape : fmt::format("<g><title>{}</title>{}</g>", escaped_markup(hover), shape);
}

/// A mark of the colour's own shape, so that prints without colour can be read.
std::string mark(int color, double x, double y) {
  const std::string c = color_class(color);
  switch (color % 4) {
    case 0:
      return fmt::format("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" />", c, x, y);
    case 1:
      return fmt::format("<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"5.4\" height=\"5.4\" />", c,
                         x - 2.7, y - 2.7);
    case 2:
      return fmt::format("<path class=\"{}\" d=\"M{:.1f} {:.1f}l3.6 6.2h-7.2z\"/>", c, x, y - 3.8);
    default:
      return fmt::format("<path class=\"{}\" d=\"M{:.1f} {:.1f}l3.7 3.7l-3.7 3.7l-3.7 -3.7z\"/>", c, x,
                         y - 3.7);
  }
}

std::string legend_entry(int color, bool joined, bool marked, const std::string& text, double y) {
  std::string svg;
  if (joined)
    svg += fmt::format("<line class=\"{} wire\" x1=\"{:.0f}\" y1=\"{:.1f}\" x2=\"{:.0f}\" y2=\"{:.1f}\" />",
                       color_class(color), left, y - 4, left + 20, y - 4);
  if (marked) svg += mark(color, left + 10, y - 4);
  return svg + fmt::format("<text x=\"{:.0f}\" y=\"{:.1f}\">{}</text>\n", left + 27, y, escaped_markup(text));
}

std::string x_axis(const ChartAxis& axis, const std::vector<double>& ticks, const Scale& x, double y_top,
                   double y_bottom) {
  std::string svg;
  for (const double t : ticks)
    svg += fmt::format(
        "<line class=\"grid\" x1=\"{0:.1f}\" y1=\"{1:.1f}\" x2=\"{0:.1f}\" y2=\"{2:.1f}\" /><text "
        "class=\"tick\" x=\"{0:.1f}\" y=\"{3:.1f}\" "
        "text-anchor=middle>{4}</text>\n",
        x(t), y_top, y_bottom, y_bottom + 14, tick_text(t));
  return svg + fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n",
                           (x.from + x.to) / 2, y_bottom + 31, escaped_markup(axis.label));
}

std::string y_axis(const ChartAxis& axis, const std::vector<double>& ticks, const Scale& y) {
  std::string svg;
  for (const double t : ticks)
    svg += fmt::format(
        "<line class=\"grid\" x1=\"{0:.0f}\" y1=\"{1:.1f}\" x2=\"{2:.0f}\" y2=\"{1:.1f}\" /><text "
        "class=\"tick\" x=\"{3:.0f}\" y=\"{4:.1f}\" "
        "text-anchor=end>{5}</text>\n",
        left, y(t), width - right, left - 6, y(t) + 4, tick_text(t));
  const double middle = top + plot_height / 2;
  return svg + fmt::format(
                   "<text x=\"12\" y=\"{0:.1f}\" text-anchor=\"middle\" transform=\"rotate(-90 12 "
                   "{0:.1f})\">{1}</text>\n",
                   middle, escaped_markup(axis.label));
}

/// The line of a series and the band of its intervals, cut off where they leave the plot.
std::string wire_svg(const ChartSeries& series, const Scale& x, const Scale& y) {
  std::string line, above, below;
  for (const ChartPoint& p : series.points) {
    line += fmt::format("{:.1f},{:.1f} ", x(p.x), y(p.y));
    if (!p.lo || !p.hi) continue;
    above += fmt::format("{:.1f},{:.1f} ", x(p.x), y(*p.hi));
    below = fmt::format("{:.1f},{:.1f} ", x(p.x), y(*p.lo)) + below;
  }
  std::string svg = fmt::format(
      "<svg x=\"{0:.0f}\" y=\"{1:.0f}\" width=\"{2:.0f}\" height=\"{3:.0f}\" viewBox=\"{0:.0f} {1:.0f} "
      "{2:.0f} "
      "{3:.0f}\">",
      left, top, width - left - right, plot_height);
  const std::string c = color_class(series.color);
  if (!series.marked && !above.empty())
    svg += fmt::format("<polygon class=\"{} band\" points=\"{}{}\"/>", c, above, below);
  return svg + fmt::format("<polyline class=\"{} wire\" points=\"{}\"/></svg>\n", c, line);
}

std::string series_svg(const ChartSeries& series, const Scale& x, const Scale& y) {
  std::string svg;
  if (series.joined && series.points.size() > 1) svg += wire_svg(series, x, y);
  for (const ChartPoint& p : series.points) {
    std::string shape;
    if (p.lo && p.hi && series.marked)
      shape += fmt::format(
          "<line class=\"{0} bar\" x1=\"{1:.1f}\" y1=\"{2:.1f}\" x2=\"{1:.1f}\" y2=\"{3:.1f}\" />",
          color_class(series.color), x(p.x), y(*p.lo), y(*p.hi));
    if (series.marked)
      shape += mark(series.color, x(p.x), y(p.y));
    else if (!p.hover.empty())  // something to point at
      shape += fmt::format("<circle class=\"touch\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\" />", x(p.x), y(p.y));
    if (!shape.empty()) svg += titled(p.hover, shape) + '\n';
  }
  return svg;
}

std::string svg_of(const ReportChart& chart, const XyChart& body) {
  Limits x_limits, y_limits;
  for (const ChartSeries& series : body.series)
    for (const ChartPoint& p : series.points) {
      x_limits.add(p.x);
      for (const double v : {p.y, p.lo.value_or(p.y), p.hi.value_or(p.y)}) y_limits.add(v);
    }
  const std::vector<double> x_ticks = ticks_of(body.x, x_limits, 6), y_ticks = ticks_of(body.y, y_limits, 5);
  const Scale x = scale_of(body.x, x_ticks, left, width - right);
  const Scale y = scale_of(body.y, y_ticks, top + plot_height, top);
  std::string svg = x_axis(body.x, x_ticks, x, top, top + plot_height) + y_axis(body.y, y_ticks, y);
  double legend_y = top + plot_height + 38;
  for (const ChartSeries& series : body.series) {
    svg += series_svg(series, x, y);
    if (series.name.empty()) continue;
    legend_y += line_height;
    svg += legend_entry(series.color, series.joined, series.marked, series.name, legend_y);
  }
  return svg_open(chart, legend_y + 8) + svg + "</svg>\n";
}

std::string range_svg(const ChartRange& r, const Scale& x, double y) {
  const std::string c = color_class(r.color);
  std::string shape =
      fmt::format("<line class=\"{} bar\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" />", c,
                  x(r.low), y, x(r.high), y);
  if (r.box_low && r.box_high)
    shape += fmt::format(
        "<rect class=\"{} box\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"9\" /><line class=\"{} "
        "middle\" "
        "x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" />",
        c, x(*r.box_low), y - 4.5, std::max(1.0, x(*r.box_high) - x(*r.box_low)), c, x(r.middle), y - 4.5,
        x(r.middle), y + 4.5);
  else
    shape += mark(r.color, x(r.middle), y);
  return titled(r.hover, shape) + '\n';
}

std::string svg_of(const ReportChart& chart, const RangeChart& body) {
  Limits limits;
  for (const RangeChart::Row& row : body.rows)
    for (const ChartRange& r : row.ranges)
      for (const double v : {r.low, r.middle, r.high}) limits.add(v);
  if (body.zero_line) limits.add(0);
  double bottom = top;
  for (const RangeChart::Row& row : body.rows)
    bottom += range_row_height * std::max<double>(1, static_cast<double>(row.ranges.size())) + 7;
  const std::vector<double> ticks = ticks_of(body.axis, limits, 5);
  const Scale x = scale_of(body.axis, ticks, range_label_width, width - right);
  std::string svg = x_axis(body.axis, ticks, x, top, bottom);
  if (body.zero_line)
    svg +=
        fmt::format("<line class=\"zero\" x1=\"{0:.1f}\" y1=\"{1:.0f}\" x2=\"{0:.1f}\" y2=\"{2:.1f}\" />\n",
                    x(0), top, bottom);
  double y = top;
  for (const RangeChart::Row& row : body.rows) {
    const double height = range_row_height * std::max<double>(1, static_cast<double>(row.ranges.size()));
    svg += fmt::format("<text class=\"tick\" x=\"{:.0f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n",
                       range_label_width - 8, y + 3.5 + height / 2 + 4, escaped_markup(row.label));
    for (std::size_t i = 0; i < row.ranges.size(); ++i)
      svg += range_svg(row.ranges[i], x, y + 3.5 + range_row_height * (static_cast<double>(i) + 0.5));
    y += height + 7;
  }
  double legend_y = bottom + 38;
  for (std::size_t i = 0; i < body.legend.size(); ++i) {
    legend_y += line_height;
    svg += legend_entry(static_cast<int>(i), false, true, body.legend[i], legend_y);
  }
  return svg_open(chart, legend_y + 8) + svg + "</svg>\n";
}

}  // namespace

std::string chart_svg(const ReportChart& chart) {
  return std::visit([&](const auto& body) { return svg_of(chart, body); }, chart.body);
}

}  // namespace facet
