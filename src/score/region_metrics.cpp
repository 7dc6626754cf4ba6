#include "score/metric_list.hpp"

namespace facet {
namespace {

void add_detection(MetricList& list, const std::string& threshold, DetectionScore FrameScore::*score) {
  list.add_tally("surface_recall_" + threshold, metric_needs::surfaces,
                 [score](const FrameScore& f) { return (f.*score).recall(); });
  list.add_tally("surface_precision_" + threshold, metric_needs::surfaces,
                 [score](const FrameScore& f) { return (f.*score).precision(); });
  list.add_ratio("surface_f1_" + threshold, metric_needs::surfaces, [score](const FrameScore& f) {
    const DetectionScore& s = f.*score;
    return MetricSums{2.0 * s.detected, 1.0 * s.detected + s.wrong + s.truth};
  });
}

void add_surfaces(MetricList& list) {
  add_detection(list, "0.5", &FrameScore::surfaces_50);
  add_detection(list, "0.75", &FrameScore::surfaces_75);
  list.add_tally("surface_recall_graspable_0.5", metric_needs::surfaces,
                 [](const FrameScore& f) { return f.grasps.surfaces; });
  list.add_ratio("mean_iou", metric_needs::surfaces, [](const FrameScore& f) {
    return MetricSums{f.surfaces_50.iou_total, 1.0 * f.surfaces_50.detected};
  });
  list.add_ratio("pq", metric_needs::surfaces, [](const FrameScore& f) {
    const DetectionScore& s = f.surfaces_50;
    return MetricSums{s.iou_total, 0.5 * s.detected + 0.5 * s.wrong + 0.5 * s.truth};
  });
  list.add_ratio("surface_count_ratio", metric_needs::surfaces, [](const FrameScore& f) {
    return MetricSums{1.0 * f.surfaces_50.detected + f.surfaces_50.wrong, 1.0 * f.surfaces_50.truth};
  });
  const auto add_hoover = [&list](const char* name, int HooverCounts::*hit, int HooverCounts::*of) {
    list.add_tally(name, metric_needs::surfaces, [hit, of](const FrameScore& f) {
      return Tally{f.hoover().*hit, f.hoover().*of};
    });
  };
  add_hoover("hoover_correct_0.8", &HooverCounts::correct, &HooverCounts::truth);
  add_hoover("hoover_over_0.8", &HooverCounts::over, &HooverCounts::truth);
  add_hoover("hoover_under_0.8", &HooverCounts::under_truth, &HooverCounts::truth);
  add_hoover("hoover_missed_0.8", &HooverCounts::missed, &HooverCounts::truth);
  add_hoover("hoover_noise_0.8", &HooverCounts::noise, &HooverCounts::predicted);
}

void add_overlap(MetricList& list, const std::string& item, const MetricNeeds& needs,
                 OverlapScore FrameScore::*score) {
  list.add_precision_recall(item + "_overlap", needs, [score](const FrameScore& f) {
    const OverlapScore& s = f.*score;
    return MetricSums{1.0 * s.common_px, 1.0 * s.predicted_px, 1.0 * s.common_px, 1.0 * s.truth_px};
  });
  list.add_precision_recall(item + "_boundary", needs, [score](const FrameScore& f) {
    const OverlapScore& s = f.*score;
    return MetricSums{1.0 * s.boundary_predicted_hit, 1.0 * s.boundary_predicted, 1.0 * s.boundary_truth_hit,
                      1.0 * s.boundary_truth};
  });
  list.add_tally(item + "_f_0.75", needs, [score](const FrameScore& f) {
    return Tally{(f.*score).found_75, (f.*score).truth};
  });
}

void add_object_masks(MetricList& list) {
  // Pixels depend on each other: no Wilson interval for their shares.
  const auto add = [&list](const char* name, Tally ObjectMaskScore::*tally) {
    list.add_ratio(name, metric_needs::masks, [tally](const FrameScore& f) {
      const Tally& t = f.object_masks.*tally;
      return MetricSums{1.0 * t.hit, 1.0 * t.n};
    });
  };
  add("object_leakage", &ObjectMaskScore::leakage);
  add("object_coverage", &ObjectMaskScore::coverage);
  list.add_precision_recall("object_outline", metric_needs::masks, [](const FrameScore& f) {
    const Tally& p = f.object_masks.outline_precision;
    const Tally& r = f.object_masks.outline_recall;
    return MetricSums{1.0 * p.hit, 1.0 * p.n, 1.0 * r.hit, 1.0 * r.n};
  });
}

}  // namespace

void add_region_metrics(MetricList& list) {
  add_surfaces(list);
  add_overlap(list, "surface", metric_needs::surfaces, &FrameScore::surface_overlap);
  add_overlap(list, "object", metric_needs::masks, &FrameScore::object_overlap);
  add_object_masks(list);
}

}  // namespace facet
