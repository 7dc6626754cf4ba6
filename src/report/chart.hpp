#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace facet {

/// What an axis shows; its limits follow from the data unless they are given.
struct ChartAxis {
  std::string label;  ///< with the unit in brackets, "time [ms]"
  std::optional<double> lowest, highest;
  bool logarithmic = false;  ///< of a RangeChart; values below `lowest` stand at it
};

/// A value, with its interval where it has one. `hover` is shown by browsers when pointed at.
struct ChartPoint {
  double x = 0, y = 0;
  std::optional<double> lo, hi;  ///< of y
  std::string hover;
};

/// Points of one colour, or a line through them. Series of one `color` belong together.
struct ChartSeries {
  std::string name;  ///< in the legend; empty: not there
  int color = 0;
  bool joined = false;  ///< a line through the points
  bool marked = true;   ///< a mark at every point; a line without marks has its intervals as a band
  std::vector<ChartPoint> points;
};

/// y over x.
struct XyChart {
  ChartAxis x, y;
  std::vector<ChartSeries> series;
};

/// A range on a row of a RangeChart: an interval about a value, or quantiles with a box about the median.
struct ChartRange {
  int color = 0;
  double low = 0, middle = 0, high = 0;
  std::optional<double> box_low, box_high;
  std::string hover;
};

/// Rows of ranges over a common axis: box plots of times, effects with intervals.
struct RangeChart {
  struct Row {
    std::string label;
    std::vector<ChartRange> ranges;
  };
  ChartAxis axis;
  std::vector<std::string> legend;  ///< names of the colours from 0 on
  std::vector<Row> rows;
  bool zero_line = false;  ///< effects are read against zero
};

struct ReportChart {
  std::string title;
  std::variant<XyChart, RangeChart> body;
  std::vector<std::string> notes{};  ///< below the chart
};

/// Round values that cover [low, high], about `count` of them: 1, 2 or 5 times a power of ten apart.
std::vector<double> axis_ticks(double low, double high, int count);

/// The powers of ten that cover [low, high], and 2 and 5 times those where that is not too many; low > 0.
std::vector<double> logarithmic_ticks(double low, double high);

/// The chart as an element `svg` whose colours are those of chart_style(). A small writer of our own: what
/// Debian ships either needs a display toolkit or cannot follow a page's colours and show values.
std::string chart_svg(const ReportChart& chart);
/// CSS of the charts on a page: colours for light and dark.
std::string chart_style();

}  // namespace facet
