#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace facet {

/// Arithmetic mean; 0 for no values.
double mean_of(std::span<const double> values);
/// Sample standard deviation (n - 1); 0 for fewer than two values.
double deviation_of(std::span<const double> values);
/// Values whose modified z score 0.6745 |x - median| / MAD exceeds 3.5 (Iglewicz and Hoaglin 1993); none
/// where the MAD is 0.
int count_outliers(std::span<const double> values);

/// Least samples for a percentile whose distribution-free 95 % interval is bounded: 64 for p90, 130 for p95,
/// 662 for p99, and 6 for the median.
int least_samples_for(int percentile);

/// Quantile of Student's t distribution at 0.975, that is half a two-sided 95 % interval. `degrees` >= 1.
double student_t_975(int degrees);

/// Least-squares line y = intercept + slope x with the 95 % interval of its slope.
struct LineFit {
  double intercept = 0;
  double slope = 0;
  double slope_low = 0;
  double slope_high = 0;
  int n = 0;
};
/// Nothing where there are fewer than three points or all x are equal.
std::optional<LineFit> fit_line(std::span<const double> x, std::span<const double> y);

}  // namespace facet
