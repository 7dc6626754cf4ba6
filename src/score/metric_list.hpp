#pragma once

#include "score/metrics.hpp"

namespace facet {

/// What a group of metrics needs.
struct MetricNeeds {
  AnnotatedParts truth;
  PredictedParts prediction;
};
namespace metric_needs {
inline constexpr MetricNeeds surfaces{{.surfaces = true}, {}};
inline constexpr MetricNeeds masks{{.masks = true}, {}};
inline constexpr MetricNeeds edges{{.edges = true}, {.regions = false, .edges = true}};
inline constexpr MetricNeeds poses{{.surfaces = true}, {.poses = true}};
inline constexpr MetricNeeds grasps{{.surfaces = true}, {.poses = true, .grasps = true}};
inline constexpr MetricNeeds grasped_edges{{.surfaces = true, .edges = true},
                                           {.regions = false, .grasps = true}};
inline constexpr MetricNeeds true_poses{{.surfaces = true, .poses = true}, {.poses = true}};
}  // namespace metric_needs

/// The metrics in the making, and the ways to add one.
class MetricList {
 public:
  void add_tally(std::string name, const MetricNeeds& needs, std::function<Tally(const FrameScore&)> tally);
  void add_ratio(std::string name, const MetricNeeds& needs,
                 std::function<MetricSums(const FrameScore&)> sums);
  /// NAME_precision, NAME_recall and NAME_f of the same sums.
  void add_precision_recall(const std::string& name, const MetricNeeds& needs,
                            const std::function<MetricSums(const FrameScore&)>& sums);
  std::vector<Metric> metrics;
};

/// Detection, Hoover's classes, overlap and boundary of surfaces; overlap, boundary and masks of objects.
void add_region_metrics(MetricList& list);
void add_edge_metrics(MetricList& list);
/// Objects and surfaces to be taken, and poses.
void add_grasp_metrics(MetricList& list);

}  // namespace facet
