// Laws that every scorer must keep: perfect predictions, empty ones, wrong ones.
#include <gtest/gtest.h>

#include "score/connected_parts.hpp"
#include "score/perfect_score.hpp"
#include "score/truth_prediction.hpp"
#include "synth/families.hpp"
#include "synth_io/scene_annotation.hpp"

namespace facet {
namespace {

/// A random view of a family with its exact truth.
FrameTruth synthetic_truth(const SceneRecipe& family, std::uint64_t index) {
  const Size size = kinect_v1_size();
  const Camera camera = kinect_v1_camera();
  const View view = random_layout(family, 31, index, camera, size).view;
  const PosedScene posed(view.scene, view.T_world_camera);
  const Rendering exact = render(posed, camera, size);
  const SceneTruth scene = scene_truth(view, posed, exact, camera);
  std::vector<TruePose> poses;
  for (std::size_t f = 0; f < scene.faces.size(); ++f)
    poses.push_back({static_cast<int>(f) + 1, scene.faces[f].plane, scene.faces[f].centroid_m});
  return frame_truth(truth_of(scene, exact), exact.object_ids, exact.depth_m, std::move(poses));
}

const std::vector<FrameTruth>& truths() {
  static const std::vector<FrameTruth> all = [] {
    std::vector<FrameTruth> frames;
    for (const SceneRecipe& family : scene_families())
      frames.push_back(synthetic_truth(family, frames.size()));
    return frames;
  }();
  return all;
}

TEST(SelfTest, TruthAsPredictionIsPerfect) {
  for (const FrameTruth& frame : truths()) {
    SCOPED_TRACE(frame.scored_surfaces.size());
    expect_perfect(score_frame(frame, truth_as_prediction(frame)));
  }
}

TEST(SelfTest, ObjectMasksAsPredictionArePerfect) {
  for (const FrameTruth& annotated : truths()) {
    const FrameTruth frame = frame_truth(annotated.mask_object, {});
    expect_perfect(score_frame(frame, truth_as_prediction(frame)));
  }
}

TEST(SelfTest, PerfectLabelsSplitIntoTheirConnectedPartsDetectEverySurface) {
  for (const FrameTruth& frame : truths()) {
    Prediction prediction = truth_as_prediction(frame);
    const ConnectedParts parts = connected_parts(prediction.labels, 1);
    for (int y = 0; y < frame.size.height; ++y)
      for (int x = 0; x < frame.size.width; ++x)
        prediction.labels(x, y) = static_cast<std::uint16_t>(parts.map(x, y));
    std::vector<Surface> surfaces;
    for (std::size_t p = 0; p < parts.parts.size(); ++p) {
      surfaces.push_back(prediction.surfaces[static_cast<std::size_t>(parts.parts[p].label - 1)]);
      surfaces.back().id = static_cast<int>(p) + 1;
      surfaces.back().area_px = parts.parts[p].area_px;
    }
    prediction.surfaces = surfaces;
    const FrameScore score = score_frame(frame, prediction);
    EXPECT_EQ(score.surfaces_50.recall(), (Tally{score.surfaces_50.truth, score.surfaces_50.truth}));
    EXPECT_EQ(score.surfaces_75.detected, score.surfaces_75.truth);
    EXPECT_EQ(score.surfaces_75.wrong, 0);
    EXPECT_EQ(score.hoover().missed, 0);
    EXPECT_EQ(score.grasps.objects_grasp.hit, score.grasps.objects_grasp.n);
  }
}

TEST(SelfTest, AnEmptyPredictionScoresNothing) {
  for (const FrameTruth& frame : truths()) {
    const FrameScore score = score_missing_prediction(frame);
    for (const Metric& metric : score_metrics()) {
      // Nothing predicted has the precision 1 by the overlap protocol, and misses what there is.
      const bool is_protocol = metric.rule == MetricRule::precision || metric.name == "hoover_missed_0.8";
      const auto value = metric.value(metric.sums(score));
      if (value && !is_protocol) {
        EXPECT_EQ(*value, 0) << metric.name;
      }
    }
  }
}

TEST(SelfTest, PermutedLabelsChangeNothing) {
  for (const FrameTruth& frame : truths()) {
    Prediction prediction = truth_as_prediction(frame);
    const auto permuted = [](int id) { return 5000 - 13 * id; };
    for (int y = 0; y < frame.size.height; ++y)
      for (int x = 0; x < frame.size.width; ++x)
        if (prediction.labels(x, y) != 0)
          prediction.labels(x, y) = static_cast<std::uint16_t>(permuted(prediction.labels(x, y)));
    for (Surface& surface : prediction.surfaces) surface.id = permuted(surface.id);
    expect_perfect(score_frame(frame, prediction));
  }
}

TEST(SelfTest, LabelsOffByOneInTheListOfSurfacesAreNoticed) {
  int wrong = 0;
  for (const FrameTruth& frame : truths()) {
    Prediction prediction = truth_as_prediction(frame);
    for (Surface& surface : prediction.surfaces) ++surface.id;
    const FrameScore score = score_frame(frame, prediction);
    wrong += score.grasps.objects_grasp.n - score.grasps.objects_grasp.hit;
    EXPECT_LT(score.poses.success_10.hit, score.poses.success_10.n);
  }
  EXPECT_GT(wrong, 0);
}

TEST(SelfTest, AWrongKindOfEdgeIsNoticed) {
  for (const FrameTruth& frame : truths()) {
    Prediction prediction = truth_as_prediction(frame);
    for (int y = 0; y < frame.size.height; ++y) {
      for (int x = 0; x < frame.size.width; ++x) {
        std::uint8_t& code = prediction.edges(x, y);
        if (code != 0) code = static_cast<std::uint8_t>((code & graspable_edge_bit) | ((code & 3) % 3 + 1));
      }
    }
    const FrameScore score = score_frame(frame, prediction);
    EXPECT_LT(score.edges.recall_6px.all.hit, 0.2 * score.edges.recall_6px.all.n);
    EXPECT_EQ(score.edges.recall_kind_ignored_6px.all.hit, score.edges.recall_kind_ignored_6px.all.n);
  }
}

}  // namespace
}  // namespace facet
