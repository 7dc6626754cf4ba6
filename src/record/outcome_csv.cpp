#include "record/outcome_csv.hpp"

#include <array>
#include <fmt/format.h>

#include "record/csv.hpp"

namespace facet {
namespace {

constexpr std::array<const char*, 4> kind_names{"none", "depth", "convex", "concave"};

std::string flag(bool value) {
  return value ? "1" : "0";
}

}  // namespace

std::string surfaces_csv(const std::vector<FrameRow>& rows) {
  std::string text = csv_line({"dataset", "frame", "method", "surface", "object", "area_px", "graspable",
                               "curved", "found_region", "iou"});
  for (const FrameRow& row : rows) {
    if (!row.score) continue;
    for (const SurfaceOutcome& s : row.score->surfaces)
      text += csv_line({row.dataset, row.frame, row.method, std::to_string(s.number),
                        std::to_string(s.object), std::to_string(s.area_px), flag(s.graspable),
                        flag(s.curved), s.region == 0 ? "" : std::to_string(s.region),
                        s.region == 0 ? "" : fmt::format("{:.4f}", s.iou)});
  }
  return text;
}

std::string edges_csv(const std::vector<FrameRow>& rows) {
  std::string text = csv_line({"dataset", "frame", "method", "edge", "object", "kind", "graspable", "samples",
                               "hit_6px", "labelled_6px", "detected_6px"});
  for (const FrameRow& row : rows) {
    if (!row.score) continue;
    for (const EdgeOutcome& e : row.score->edges.outcomes)
      text += csv_line({row.dataset, row.frame, row.method, std::to_string(e.number),
                        std::to_string(e.object), kind_names.at(static_cast<std::size_t>(e.kind)),
                        flag(e.graspable), std::to_string(e.samples), std::to_string(e.hit_6px),
                        std::to_string(e.labelled_6px), flag(e.detected_6px)});
  }
  return text;
}

}  // namespace facet
