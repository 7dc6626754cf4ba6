#include "score/summary.hpp"

#include <gtest/gtest.h>

#include "score/desk.hpp"
#include "score/truth_prediction.hpp"
#include "support/expect_error.hpp"

namespace facet {
namespace {

constexpr BootstrapOptions quick{200, 1};

FrameTruth desk_frame() {
  return frame_truth(desk(), desk_masks(), {});
}

/// A frame with one object and one surface, box 2 of the desk.
FrameTruth small_frame() {
  Truth truth = desk();
  truth.surfaces.erase(truth.surfaces.begin(), truth.surfaces.begin() + 2);
  std::erase_if(truth.edges, [](const TruthEdge& e) { return e.object == 1; });
  return frame_truth(truth, {}, {});
}

FrameScore perfect(const FrameTruth& frame) {
  return score_frame(frame, truth_as_prediction(frame));
}

TEST(ScoreSummary, PoolsCountsAndAveragesFrames) {
  ScoreCollection collection;
  collection.frames = {{perfect(desk_frame()), ""}, {score_missing_prediction(small_frame()), ""}};
  const ScoreSummary summary = summarise_scores(collection, quick);
  const MetricSummary& recall = summary.metric("surface_recall_0.5");
  EXPECT_EQ(recall.hit, 3);
  EXPECT_EQ(recall.n, 4);
  EXPECT_DOUBLE_EQ(*recall.micro, 0.75);
  EXPECT_DOUBLE_EQ(*recall.macro, 0.5);
  EXPECT_NEAR(recall.micro_interval->lo, wilson_interval(3, 4).lo, 1e-12);
  const MetricSummary& precision = summary.metric("surface_precision_0.5");
  EXPECT_DOUBLE_EQ(*precision.micro, 1);
  EXPECT_EQ(precision.macro_frames, 1);
  EXPECT_EQ(precision.frames_without, 1);
}

TEST(ScoreSummary, CountsFailedFramesAndHarnessErrors) {
  ScoreCollection collection;
  collection.frames = {{perfect(desk_frame()), ""}, {score_missing_prediction(desk_frame()), ""}};
  collection.harness_errors = 3;
  const FrameCounts counts = summarise_scores(collection, quick).counts;
  EXPECT_EQ(counts.n_total, 5);
  EXPECT_EQ(counts.n_scored, 1);
  EXPECT_EQ(counts.n_method_failed, 1);
  EXPECT_EQ(counts.n_harness_error, 3);
}

TEST(ScoreSummary, AFailedFrameHasNoHitsButEveryDenominator) {
  const FrameTruth frame = desk_frame();
  const FrameScore good = perfect(frame), failed = score_missing_prediction(frame);
  EXPECT_TRUE(failed.failed);
  for (const Metric& metric : score_metrics()) {
    if (metric.name.find("precision") != std::string::npos ||
        metric.name.find("noise") != std::string::npos || metric.name == "mean_iou" ||
        metric.rule != MetricRule::proportion)
      continue;
    const MetricSums a = metric.sums(good), b = metric.sums(failed);
    if (metric.name != "hoover_missed_0.8") {
      EXPECT_EQ(b[0], 0) << metric.name;
    }
    EXPECT_EQ(a[1], b[1]) << metric.name;
  }
}

TEST(ScoreSummary, LabelsAloneLeaveTheOtherScoresNotProvided) {
  const FrameTruth frame = desk_frame();
  Prediction labels;
  labels.labels = truth_as_prediction(frame).labels;
  ScoreCollection collection;
  collection.frames = {{score_frame(frame, labels), ""}};
  const ScoreSummary summary = summarise_scores(collection, quick);
  EXPECT_DOUBLE_EQ(*summary.metric("surface_recall_0.75").micro, 1);
  EXPECT_EQ(summary.metric("edge_recall_graspable_6px").not_provided, "the predictions have no edges");
  EXPECT_EQ(summary.metric("objects_pose").not_provided, "the predictions have no poses");
  EXPECT_EQ(summary.metric("objects_by_grasp").not_provided, "the predictions have no grasps");
  EXPECT_EQ(summary.metric("pose_auc").not_provided, "the truth has no poses");
  EXPECT_FALSE(summary.metric("edge_recall_graspable_6px").micro);
  EXPECT_EQ(summary.errors[0].not_provided, "the truth has no poses");
}

TEST(ScoreSummary, WhatAMethodYieldsForSomeFramesCountsAsMissedInTheOthers) {
  const FrameTruth frame = desk_frame();
  Prediction without_edges = truth_as_prediction(frame);
  without_edges.edges = {};
  ScoreCollection collection;
  collection.frames = {{perfect(frame), ""}, {score_frame(frame, without_edges), ""}};
  const ScoreSummary summary = summarise_scores(collection, quick);
  EXPECT_EQ(summary.metric("edge_recall_all_6px").hit, 9);
  EXPECT_EQ(summary.metric("edge_recall_all_6px").n, 18);
  EXPECT_DOUBLE_EQ(*summary.metric("boundary_recall_depth").micro, 0.5);
}

TEST(ScoreSummary, FramesWithMasksAloneServeTheScoresOfObjectsAlone) {
  const FrameTruth masks_alone = frame_truth(desk_masks(), {});
  ScoreCollection collection;
  collection.frames = {{perfect(masks_alone), ""}};
  const ScoreSummary summary = summarise_scores(collection, quick);
  EXPECT_DOUBLE_EQ(*summary.metric("object_overlap_f").micro, 1);
  EXPECT_EQ(summary.metric("surface_recall_0.5").not_provided, "the truth has no surfaces");
  EXPECT_EQ(summary.metric("edge_precision_6px").not_provided, "the truth has no edges");
  collection.frames.push_back({perfect(desk_frame()), ""});
  const ScoreSummary both = summarise_scores(collection, quick);
  EXPECT_EQ(both.metric("surface_recall_0.5").n, 3);
  EXPECT_EQ(both.metric("surface_recall_0.5").frames_not_annotated, 1);
}

TEST(ScoreSummary, OfNothingAtAllProvidesNothing) {
  const ScoreSummary summary = summarise_scores({}, quick);
  EXPECT_EQ(summary.counts.n_total, 0);
  EXPECT_EQ(summary.metric("surface_recall_0.5").not_provided, "no frame was scored");
}

TEST(ScoreSummary, HasEveryKeyOnce) {
  std::vector<std::string> names;
  for (const Metric& m : score_metrics()) names.push_back(m.name);
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
  for (const char* key :
       {"surface_recall_0.5", "surface_precision_0.75", "hoover_correct_0.8", "edge_recall_graspable_6px",
        "edge_recall_concave_3px", "edge_precision_6px", "edge_recall_kind_ignored_6px",
        "edge_precision_kind_ignored_6px", "objects_grasp", "objects_pose", "objects_all_surfaces",
        "surfaces_by_grasp", "objects_by_grasp", "surface_count_ratio", "mean_iou", "pq"})
    EXPECT_TRUE(std::binary_search(names.begin(), names.end(), key)) << key;
  expect_error(ErrorKind::internal, "no metric is called x", [] { score_metric("x"); });
}

TEST(ScoreSummary, StrataHoldEveryFrameOnceByAxis) {
  ScoreCollection collection;
  collection.frames = {{perfect(desk_frame()), ""},
                       {perfect(small_frame()), ""},
                       {perfect(frame_truth(desk_masks(), {})), ""}};
  std::map<std::string, int> frames;
  for (const Stratum& s : stratify_scores(collection, quick)) frames[s.axis] += s.summary.counts.n_total;
  EXPECT_EQ(frames["objects"], 3);
  EXPECT_EQ(frames["surfaces"], 2);
  EXPECT_EQ(frames["occluded_share"], 2);
  EXPECT_EQ(frames["contacts"], 2);
}

}  // namespace
}  // namespace facet
