#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "record/timing_row.hpp"
#include "report/statistics.hpp"

namespace facet {

/// What the paper's Table 3 prints for a row, on a GTX 1070 and other data.
struct PaperTime {
  double mean_ms = 0;
  double deviation_ms = 0;
};

/// A row of the timing table: a sum of measured stages. Sums are per sample, so that deviations are right.
struct TimingRowLayout {
  std::string_view label;
  std::span<const std::string_view> stages;  ///< keys
  bool indented = false;                     ///< a part of the row above
  std::optional<PaperTime> paper;
};

/// The stage rows of Table 3 in its order, with the rows it lacks. Every stage of the pipeline
/// before the poses stands in exactly one row that is not indented.
std::span<const TimingRowLayout> table3_layout();

inline constexpr std::array<double, 2> deadlines_ms{30.0, 33.3};
inline constexpr std::array<int, 4> percentiles{50, 90, 95, 99};

/// Statistics of the steady samples of one quantity.
struct TimeStatistics {
  int n = 0;
  double mean_ms = 0;
  double deviation_ms = 0;
  double min_ms = 0;
  double max_ms = 0;
  std::array<std::optional<double>, 4> percentile_ms;  ///< empty where there are too few samples
  std::array<double, 5> box_ms{};                      ///< quantiles 5, 25, 50, 75 and 95 %, for pictures
  std::array<int, 2> deadline_misses{};
  int outliers = 0;  ///< flagged, and kept in every other figure
};
TimeStatistics summarize_times(std::span<const double> ms);

struct NamedTimes {
  std::string name;
  TimeStatistics times;
};

/// Times of one method on one data set.
struct TimingSummary {
  std::string dataset;
  std::string method;
  std::vector<NamedTimes> layout;  ///< in the order of table3_layout()
  std::vector<NamedTimes> stages;  ///< every stage by its key
  TimeStatistics total;
  TimeStatistics total_without_pose;  ///< nor grasps: what the paper times
  TimeStatistics unattributed;
  TimeStatistics pose;
  TimeStatistics grasps;
  std::optional<double> pose_per_surface_ms;  ///< pose time over posed surfaces, of all steady samples
  std::optional<double> first_ms;             ///< the very first run
  TimeStatistics warmup;
  double repeat_deviation_ms = 0;            ///< of repeats of one frame, pooled over frames
  std::optional<double> frame_deviation_ms;  ///< between the means of different frames, two frames at least
  std::optional<LineFit> by_surfaces;        ///< frame means of the total [ms] over their number of surfaces
  int frames = 0;
};

/// One summary per (data set, method), in the order of their first samples.
std::vector<TimingSummary> summarize_timing(const TimingTable& table);

/// timing/stages.csv.
std::string stages_csv(const std::vector<TimingSummary>& summaries);

}  // namespace facet
