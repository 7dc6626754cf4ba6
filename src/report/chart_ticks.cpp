#include <cmath>

#include "report/chart.hpp"

namespace facet {

std::vector<double> axis_ticks(double low, double high, int count) {
  if (!(high > low)) return {low};
  const double rough = (high - low) / count;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough * 0.999) {
      step = factor * power;
      break;
    }
  }
  std::vector<double> ticks;
  const auto first = static_cast<long>(std::floor(low / step + 1e-9));
  for (long i = first; ticks.empty() || ticks.back() < high - 1e-9 * step; ++i)
    ticks.push_back(static_cast<double>(i) * step);
  return ticks;
}

std::vector<double> logarithmic_ticks(double low, double high) {
  const bool wide = high > 300 * low;
  std::vector<double> ticks;
  for (double power = std::pow(10.0, std::floor(std::log10(low) + 1e-9));
       ticks.empty() || ticks.back() < high; power *= 10)
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double tick = factor * power;
      if (wide && factor != 1) continue;  // no room for their labels
      if (2.5 * tick <= low || (!ticks.empty() && ticks.back() >= high)) continue;
      ticks.push_back(tick);
    }
  return ticks;
}

}  // namespace facet
