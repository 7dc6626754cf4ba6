#pragma once

#include <optional>
#include <string>
#include <vector>

#include "record/frame_row.hpp"
#include "score/intervals.hpp"

namespace facet {

/// How far the recall of surfaces falls from the nominal level of an axis to its worst level, in points.
struct LevelDrop {
  double worst_level = 0, nominal_level = 0;
  double points = 0;                 ///< worst minus nominal
  std::optional<Interval> interval;  ///< bootstrap over scenes, the same ones drawn at both levels
  int scenes = 0;
};

/// Pooled surface recall at IoU 0.5 of the frames of a data set, by level of its axis. `rows` are of one
/// method. Nothing where fewer than two levels are scored, or the nominal one is not among them.
std::optional<LevelDrop> level_drop(const std::vector<FrameRow>& rows, const std::string& dataset,
                                    double nominal, int replicates);

/// The paper's claim of invariance: the interval lies within 5 points of zero.
bool is_invariant(const LevelDrop& drop);

}  // namespace facet
