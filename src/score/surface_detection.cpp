#include "score/surface_detection.hpp"

namespace facet {

DetectionScore score_detection(const TruthLabels& truth, const std::vector<RegionMatch>& matches,
                               const std::vector<RegionClass>& classes) {
  DetectionScore score{.truth = static_cast<int>(truth.size()), .detected = static_cast<int>(matches.size())};
  for (const RegionMatch& match : matches) score.iou_total += match.iou;
  const auto count = [&](RegionClass c) {
    return static_cast<int>(std::count(classes.begin(), classes.end(), c));
  };
  score.wrong = count(RegionClass::wrong);
  score.table = count(RegionClass::table);
  score.background = count(RegionClass::background);
  score.ignored = count(RegionClass::ignored);
  score.tiny = count(RegionClass::tiny);
  return score;
}

}  // namespace facet
