#include "score/predicted_regions.hpp"

#include <fmt/core.h>
#include <map>
#include <set>

#include "core/error.hpp"

namespace facet {
namespace {

void require_size(Size size, Size expected, const char* what) {
  if (size == expected) return;
  throw Error(ErrorKind::data, fmt::format("the {} are {}x{} px, the truth {}x{} px", what, size.width,
                                           size.height, expected.width, expected.height));
}

/// Regions of the labels; labels with the same representative are one region. A representative is a label or,
/// beyond 65535, the name of a group.
PredictedRegions regions_by(const TruthLabels& truth, const Image<std::uint16_t>& labels,
                            const std::vector<int>& representative) {
  std::vector<std::uint8_t> present(65536, 0);
  for (int y = 0; y < labels.height(); ++y)
    for (int x = 0; x < labels.width(); ++x) present[labels(x, y)] = 1;
  PredictedRegions out{Image<std::uint16_t>(labels.size(), 0), {}};
  std::map<int, std::uint16_t> by_representative;
  std::vector<std::uint16_t> index(65536, 0);
  for (int id = 1; id < 65536; ++id) {
    if (present[static_cast<std::size_t>(id)] == 0) continue;
    const auto next = static_cast<std::uint16_t>(out.regions.size() + 1);
    const auto [at, is_new] = by_representative.emplace(representative[static_cast<std::size_t>(id)], next);
    if (is_new) out.regions.emplace_back();
    out.regions[at->second - 1u].ids.push_back(id);
    index[static_cast<std::size_t>(id)] = at->second;
  }
  for (int y = 0; y < labels.height(); ++y) {
    for (int x = 0; x < labels.width(); ++x) {
      const std::uint16_t region = index[labels(x, y)];
      if (region == 0) continue;
      PredictedRegion& r = out.regions[region - 1u];
      const TruthRegion ground = truth.regions(x, y);
      if (ground == TruthRegion::ignored) {
        ++r.void_px;
        continue;
      }
      out.map(x, y) = region;
      ++r.area_px;
      if (ground == TruthRegion::support) ++r.support_px;
    }
  }
  return out;
}

std::vector<int> every_label_by_itself() {
  std::vector<int> representative(65536);
  for (int id = 0; id < 65536; ++id) representative[static_cast<std::size_t>(id)] = id;
  return representative;
}

}  // namespace

void require_size_of_truth(const FrameTruth& truth, const Prediction& prediction) {
  require_size(prediction.labels.size(), truth.size, "predicted labels");
  if (!prediction.edges.empty()) require_size(prediction.edges.size(), truth.size, "predicted edges");
}

PredictedRegions surface_regions(const FrameTruth& truth, const Prediction& prediction) {
  require_size_of_truth(truth, prediction);
  std::vector<int> representative = every_label_by_itself();
  PredictedRegions single = regions_by(truth.surfaces, prediction.labels, representative);
  std::vector<int> part_count(truth.surfaces.size(), 0);
  const auto surface_of = [&](int part) {
    return static_cast<std::size_t>(truth.surface_parts.parts[static_cast<std::size_t>(part)].label - 1);
  };
  for (std::size_t p = 0; p < truth.surface_parts.parts.size(); ++p)
    ++part_count[surface_of(static_cast<int>(p))];
  std::map<std::size_t, std::set<int>> pieces;  // of a divided surface: ids
  for (const Overlap& o : count_overlaps(truth.surface_parts.map, single.map)) {
    const PredictedRegion& region = single.regions[static_cast<std::size_t>(o.b)];
    const int part_px = truth.surface_parts.parts[static_cast<std::size_t>(o.a)].area_px;
    if (part_count[surface_of(o.a)] > 1 && overlap_share(o.px, part_px, region.area_px) > 0.5)
      pieces[surface_of(o.a)].insert(region.ids[0]);
  }
  bool joins = false;
  for (const auto& [surface, ids] : pieces) {
    for (const int id : ids) representative[static_cast<std::size_t>(id)] = *ids.begin();
    joins = joins || ids.size() > 1;
  }
  return joins ? regions_by(truth.surfaces, prediction.labels, representative) : std::move(single);
}

PredictedRegions object_regions(const FrameTruth& truth, const Prediction& prediction) {
  require_size_of_truth(truth, prediction);
  std::vector<int> representative = every_label_by_itself();
  for (const Surface& surface : prediction.surfaces) {
    if (surface.object != 0 && surface.id > 0 && surface.id < 65536)
      representative[static_cast<std::size_t>(surface.id)] = 65536 + surface.object;
  }
  return regions_by(truth.objects, prediction.labels, representative);
}

}  // namespace facet
