#pragma once

#include <array>

#include "score/region_match.hpp"

namespace facet {

/// Classes of Hoover et al. 1996 (IEEE PAMI 18(7)) at one tolerance, as numbers of instances.
struct HooverCounts {
  int truth = 0, predicted = 0;  ///< surfaces that count, regions that are compared
  int correct = 0;
  int over = 0;          ///< surfaces that several regions make up
  int over_regions = 0;  ///< those regions
  int under = 0;         ///< regions that several surfaces make up
  int under_truth = 0;   ///< those surfaces
  int missed = 0;        ///< surfaces in no instance
  int noise = 0;         ///< regions in no instance
  friend bool operator==(const HooverCounts&, const HooverCounts&) = default;
};

/// `tolerance` in (0.5, 1]. A surface or region that fits several instances takes part in the one with the
/// highest mean of its two overlap shares (common pixels over the pixels of its surfaces, and over those of
/// its regions); ties: correct, over-, under-segmented, lowest index.
HooverCounts hoover_counts(const RegionComparison& comparison, double tolerance);

/// Tolerances of the curve: 0.51, 0.52, ..., 0.95.
inline constexpr int hoover_curve_points = 45;
constexpr double hoover_curve_tolerance(int i) {
  return (51 + i) / 100.0;
}

}  // namespace facet
