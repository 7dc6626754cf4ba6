#include "report/statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "score/intervals.hpp"

namespace facet {

double mean_of(std::span<const double> values) {
  if (values.empty()) return 0;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double deviation_of(std::span<const double> values) {
  if (values.size() < 2) return 0;
  const double mean = mean_of(values);
  double sum = 0;
  for (const double v : values) sum += (v - mean) * (v - mean);
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

int count_outliers(std::span<const double> values) {
  if (values.empty()) return 0;
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  const double median = sorted_quantile(sorted, 0.5);
  for (double& v : sorted) v = std::abs(v - median);
  std::sort(sorted.begin(), sorted.end());
  const double mad = sorted_quantile(sorted, 0.5);
  if (mad == 0) return 0;
  return static_cast<int>(
      std::count_if(sorted.begin(), sorted.end(), [&](double d) { return 0.6745 * d / mad > 3.5; }));
}

int least_samples_for(int percentile) {
  switch (percentile) {
    case 50:
      return 6;
    case 90:
      return 64;
    case 95:
      return 130;
    default:
      return 662;
  }
}

double student_t_975(int degrees) {
  static constexpr std::array<double, 10> small{12.7062, 4.3027, 3.1824, 2.7764, 2.5706,
                                                2.4469,  2.3646, 2.3060, 2.2622, 2.2281};
  if (degrees <= static_cast<int>(small.size()))
    return small[static_cast<std::size_t>(std::max(degrees, 1) - 1)];
  // Expansion about the normal quantile (Abramowitz and Stegun 26.7.5), within 1e-4 from 11 degrees on.
  const double z = 1.959964, n = degrees;
  const double z3 = z * z * z, z5 = z3 * z * z, z7 = z5 * z * z;
  return z + (z3 + z) / (4 * n) + (5 * z5 + 16 * z3 + 3 * z) / (96 * n * n) +
         (3 * z7 + 19 * z5 + 17 * z3 - 15 * z) / (384 * n * n * n);
}

std::optional<LineFit> fit_line(std::span<const double> x, std::span<const double> y) {
  const std::size_t n = x.size();
  if (n < 3) return std::nullopt;
  const double mean_x = mean_of(x), mean_y = mean_of(y);
  double xx = 0, xy = 0;
  for (std::size_t i = 0; i < n; ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
  }
  if (xx == 0) return std::nullopt;
  LineFit fit;
  fit.n = static_cast<int>(n);
  fit.slope = xy / xx;
  fit.intercept = mean_y - fit.slope * mean_x;
  double residual = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double r = y[i] - fit.intercept - fit.slope * x[i];
    residual += r * r;
  }
  const double half = student_t_975(fit.n - 2) * std::sqrt(residual / static_cast<double>(n - 2) / xx);
  fit.slope_low = fit.slope - half;
  fit.slope_high = fit.slope + half;
  return fit;
}

}  // namespace facet
