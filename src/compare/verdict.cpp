#include "compare/verdict.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace facet {
namespace {

/// The change with its interval turned such that positive is worse.
struct Worsening {
  double value, lo, hi;
};

Worsening worsening_of(const Change& change, Better better) {
  const double value = change.after - change.before;
  const Interval interval = change.interval.value_or(Interval{value, value});
  switch (better) {
    case Better::higher:
      return {-value, -interval.hi, -interval.lo};
    case Better::lower:
      return {value, interval.lo, interval.hi};
    default:
      if (interval.lo > 0) return {value, interval.lo, interval.hi};
      if (interval.hi < 0) return {-value, -interval.hi, -interval.lo};
      return {std::abs(value), 0, std::max(-interval.lo, interval.hi)};
  }
}

}  // namespace

std::string_view verdict_name(Verdict verdict) {
  static constexpr std::array<std::string_view, 6> names{"regressed",    "improved",     "ok",
                                                         "inconclusive", "not measured", "not comparable"};
  return names[static_cast<std::size_t>(verdict)];
}

Judgement judge(const Change& change, const Rule& rule, Better better, double alpha) {
  if (change.n < rule.least_n)
    return {Verdict::not_measured, fmt::format("n = {} < {}", change.n, rule.least_n)};
  better = rule.better.value_or(better);
  const double tolerance = std::max(rule.abs_tolerance, rule.rel_tolerance * std::abs(change.before));
  const Worsening worse = worsening_of(change, better);
  if (rule.exact) {
    if (worse.value > tolerance) return {Verdict::regressed, ""};
    return {worse.value < -tolerance ? Verdict::improved : Verdict::ok, ""};
  }
  if (!change.interval) return {Verdict::not_measured, "no interval: one sample"};
  const bool is_significant = change.p && *change.p < alpha;
  if (worse.value > tolerance && worse.lo > tolerance && is_significant) return {Verdict::regressed, ""};
  if (worse.value < -tolerance && worse.hi < -tolerance && is_significant) return {Verdict::improved, ""};
  if (worse.hi <= tolerance) return {Verdict::ok, ""};
  return {Verdict::inconclusive,
          fmt::format("worse by {:.4g}, and up to {:.4g} is possible, tolerance {:.4g}", worse.value,
                      worse.hi, tolerance)};
}

}  // namespace facet
