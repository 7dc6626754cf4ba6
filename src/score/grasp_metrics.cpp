#include "score/metric_list.hpp"

namespace facet {
namespace {

void add_grasps(MetricList& list) {
  const auto add = [&list](const char* name, const MetricNeeds& needs, Tally GraspScore::*tally) {
    list.add_tally(name, needs, [tally](const FrameScore& f) { return f.grasps.*tally; });
  };
  add("objects_grasp", metric_needs::grasps, &GraspScore::objects_grasp);
  add("objects_pose", metric_needs::poses, &GraspScore::objects_pose);
  add("objects_all_surfaces", metric_needs::surfaces, &GraspScore::objects_all_surfaces);
  add("surfaces_by_grasp", metric_needs::grasped_edges, &GraspScore::surfaces_by_grasp);
  add("objects_by_grasp", metric_needs::grasped_edges, &GraspScore::objects_by_grasp);
}

void add_poses(MetricList& list) {
  list.add_tally("pose_success_5", metric_needs::true_poses,
                 [](const FrameScore& f) { return f.poses.success_5; });
  list.add_tally("pose_success_10", metric_needs::true_poses,
                 [](const FrameScore& f) { return f.poses.success_10; });
  list.add_ratio("pose_auc", metric_needs::true_poses, [](const FrameScore& f) {
    return MetricSums{f.poses.auc_total, 1.0 * f.poses.success_5.n};
  });
}

}  // namespace

void add_grasp_metrics(MetricList& list) {
  add_grasps(list);
  add_poses(list);
}

}  // namespace facet
