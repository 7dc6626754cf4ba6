#include "paper/strip_widths.hpp"

#include <algorithm>
#include <array>

#include "file/file_bytes.hpp"
#include "paper/evaluated_frame.hpp"
#include "score/region_match.hpp"

namespace facet {
namespace {

constexpr std::array<int, 4> widths_mm{3, 5, 8, 12};

/// Index of the largest counted surface of an object; nothing where none counts.
std::optional<int> top_of(const FrameTruth& truth, int object) {
  std::optional<int> top;
  for (std::size_t i = 0; i < truth.scored_surfaces.size(); ++i) {
    if (truth.scored_surfaces[i].object != object) continue;
    if (!top || truth.surfaces.area_px[i] > truth.surfaces.area_px[static_cast<std::size_t>(*top)])
      top = static_cast<int>(i);
  }
  return top;
}

bool is_scored(const RunRecord& run, const std::string& frame) {
  return std::any_of(run.frames.begin(), run.frames.end(),
                     [&](const FrameRow& row) { return row.frame == frame && row.score; });
}

}  // namespace

Tally found_strips(const RunRecord& run, const std::pair<Experiment, Plan>& planned, int width_mm) {
  const auto& [experiment, plan] = planned;
  const int object =
      static_cast<int>(std::find(widths_mm.begin(), widths_mm.end(), width_mm) - widths_mm.begin()) + 1;
  Tally found;
  for (const PlannedDataset& data : plan.datasets)
    for (std::size_t i = 0; i < data.frames.size(); ++i) {
      if (!is_scored(run, escaped_utf8(data.data->frame_id(data.frames[i])))) continue;
      const FrameAgain again = evaluate(planned, data.spec.name, i, experiment.methods.front().name).frame;
      if (!again.truth) continue;
      const std::optional<int> top = top_of(*again.truth, object);
      if (!top) continue;
      const RegionComparison comparison = compare_regions(*again.truth, again.truth->surfaces,
                                                          surface_regions(*again.truth, again.prediction));
      found.add(std::any_of(comparison.matches.begin(), comparison.matches.end(),
                            [&](const RegionMatch& match) { return match.truth == *top; }));
    }
  return found;
}

}  // namespace facet
