#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "pipeline/result.hpp"
#include "synth/scene_truth.hpp"

namespace facet {

/// How well the best label covers a face that is really there.
struct FaceMatch {
  std::uint16_t surface_id = 0;  ///< see first_face_id()
  int area_px = 0;
  int label = 0;   ///< the label with the largest IoU
  double iou = 0;  ///< intersection over union, over all pixels
};

/// Every true surface (table and faces) of at least counted_face_px pixels, by surface id.
inline std::vector<FaceMatch> match_faces(const Image<std::uint16_t>& truth,
                                          const Image<std::uint16_t>& labels) {
  std::map<std::uint16_t, int> true_area, label_area;
  std::map<std::pair<std::uint16_t, std::uint16_t>, int> common;
  for (int y = 0; y < truth.height(); ++y)
    for (int x = 0; x < truth.width(); ++x) {
      ++true_area[truth(x, y)];
      ++label_area[labels(x, y)];
      ++common[{truth(x, y), labels(x, y)}];
    }
  std::vector<FaceMatch> matches;
  for (const auto& [id, area] : true_area) {
    if (id == 0 || area < counted_face_px) continue;
    FaceMatch match{id, area, 0, 0};
    for (const auto& [label, px] : label_area) {
      const auto shared = common.find({id, label});
      if (label == 0 || shared == common.end()) continue;
      const double iou = static_cast<double>(shared->second) / (area + px - shared->second);
      if (iou > match.iou) match.label = label, match.iou = iou;
    }
    matches.push_back(match);
  }
  return matches;
}

inline bool all_found(const std::vector<FaceMatch>& matches, double least_iou) {
  return std::all_of(matches.begin(), matches.end(), [&](const FaceMatch& m) { return m.iou >= least_iou; });
}

/// Surfaces that match no true surface with an IoU above one half and do not lie mostly on the background (id
/// 0).
inline int false_regions(const Image<std::uint16_t>& truth, const FrameResult& result) {
  std::vector<int> area(result.surfaces.size() + 1, 0), background(area);
  for (int y = 0; y < truth.height(); ++y)
    for (int x = 0; x < truth.width(); ++x) {
      ++area[result.labels(x, y)];
      background[result.labels(x, y)] += truth(x, y) == 0;
    }
  std::vector<bool> excused(area.size(), false);
  for (const FaceMatch& m : match_faces(truth, result.labels))
    if (m.iou > 0.5) excused[static_cast<std::size_t>(m.label)] = true;
  int count = 0;
  for (std::size_t label = 1; label < area.size(); ++label)
    count += !excused[label] && 2 * background[label] <= area[label];
  return count;
}

inline std::string describe(const std::vector<FaceMatch>& matches) {
  std::string text;
  for (const FaceMatch& m : matches)
    text += "face " + std::to_string(m.surface_id) + " (" + std::to_string(m.area_px) + " px): IoU " +
            std::to_string(m.iou) + "\n";
  return text;
}

}  // namespace facet
