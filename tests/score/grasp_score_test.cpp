#include "score/grasp_score.hpp"

#include <gtest/gtest.h>
#include <limits>

#include "score/desk.hpp"
#include "score/frame_score.hpp"
#include "score/truth_prediction.hpp"

namespace facet {
namespace {

class GraspScoreOfTheDesk : public testing::Test {
 protected:
  FrameTruth frame = frame_truth(desk(), desk_masks(), {});
  Prediction prediction = truth_as_prediction(frame);

  GraspScore score() const {
    return score_grasps(frame, compare_regions(frame, frame.surfaces, surface_regions(frame, prediction)),
                        prediction);
  }
};

TEST_F(GraspScoreOfTheDesk, TruthAsPredictionGetsEverything) {
  const GraspScore s = score();
  EXPECT_EQ(s.surfaces, (Tally{3, 3}));
  EXPECT_EQ(s.objects_grasp, (Tally{2, 2}));
  EXPECT_EQ(s.objects_pose, (Tally{2, 2}));
  EXPECT_EQ(s.objects_all_surfaces, (Tally{2, 2}));
  EXPECT_EQ(s.surfaces_by_grasp, (Tally{3, 3}));
  EXPECT_EQ(s.objects_by_grasp, (Tally{2, 2}));
}

TEST_F(GraspScoreOfTheDesk, AnObjectNeedsOneGraspableSurfaceWithAValidPose) {
  prediction.surfaces[0].pose.reset();
  EXPECT_EQ(score().objects_pose, (Tally{2, 2}));
  prediction.surfaces[1].pose->quaternion_wxyz = {1, 1, 0, 0};
  EXPECT_EQ(score().objects_pose, (Tally{1, 2}));
  prediction.surfaces[2].pose->centre_m.z = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(score().objects_pose, (Tally{0, 2}));
  EXPECT_EQ(score().objects_grasp, (Tally{0, 2}));
}

TEST_F(GraspScoreOfTheDesk, BothContactsMustLieOnTheObject) {
  Grasp& grasp = prediction.surfaces[2].grasps[0];
  grasp.contacts_px = {ImagePoint{98.6, 50}, ImagePoint{130.4, 50}};  // 1.4 px off, the tolerance is 1.5
  EXPECT_EQ(score().objects_grasp, (Tally{2, 2}));
  grasp.contacts_px[1].x = 130.6;
  EXPECT_EQ(score().objects_grasp, (Tally{1, 2}));
  grasp.contacts_px[1].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(score().objects_grasp, (Tally{1, 2}));
}

TEST_F(GraspScoreOfTheDesk, AnUndetectedSurfaceLosesItsObjectsCompletenessAlone) {
  fill_box<std::uint16_t>(prediction.labels, 30, 20, 70, 40, 0);
  const GraspScore s = score();
  EXPECT_EQ(s.objects_all_surfaces, (Tally{1, 2}));
  EXPECT_EQ(s.objects_grasp, (Tally{2, 2}));
}

TEST_F(GraspScoreOfTheDesk, GraspsOfNoSurfaceCountByEdgesToo) {
  prediction.labels.fill(0);
  for (const Surface& surface : prediction.surfaces)
    for (const Grasp& grasp : surface.grasps) prediction.grasps.push_back({grasp, {0, 0, 1}});
  prediction.surfaces.clear();
  EXPECT_EQ(score().surfaces_by_grasp, (Tally{3, 3}));
  EXPECT_EQ(score().objects_by_grasp, (Tally{2, 2}));
  const PredictedParts parts = parts_of(prediction);
  EXPECT_FALSE(parts.regions);
  EXPECT_TRUE(parts.grasps);
  prediction.grasps.clear();
  EXPECT_TRUE(parts_of(prediction).regions) << "nothing found is not nothing yielded";
}

TEST_F(GraspScoreOfTheDesk, GraspsCountByEdgesEvenWithoutRegions) {
  prediction.labels.fill(0);
  EXPECT_EQ(score().surfaces, (Tally{0, 3}));
  EXPECT_EQ(score().surfaces_by_grasp, (Tally{3, 3}));
  EXPECT_EQ(score().objects_by_grasp, (Tally{2, 2}));
}

TEST_F(GraspScoreOfTheDesk, AGraspOnOneEdgeOrOnAConcaveOneHoldsNothing) {
  for (Surface& surface : prediction.surfaces) surface.grasps.clear();
  Grasp grasp;
  grasp.contacts_px = {ImagePoint{100, 40}, ImagePoint{100, 80}};  // both on the left edge of box 2
  prediction.surfaces[2].grasps = {grasp};
  EXPECT_EQ(score().objects_by_grasp, (Tally{0, 2}));
  prediction.surfaces[2].grasps[0].contacts_px = {ImagePoint{115, 30}, ImagePoint{115, 89}};  // top and foot
  EXPECT_EQ(score().objects_by_grasp, (Tally{0, 2}));
  prediction.surfaces[2].grasps[0].contacts_px = {ImagePoint{100, 60}, ImagePoint{129, 60}};
  EXPECT_EQ(score().objects_by_grasp, (Tally{1, 2}));
  EXPECT_EQ(score().surfaces_by_grasp, (Tally{1, 3}));
}

TEST_F(GraspScoreOfTheDesk, OppositeSidesOfAClosedEdgeHoldARoundFace) {
  ImagePath circle;
  for (int i = 0; i <= 36; ++i)
    circle.push_back({115 + 14 * std::cos(i * 0.17453293), 60 + 14 * std::sin(i * 0.17453293)});
  Truth truth = desk();
  std::erase_if(truth.edges, [](const TruthEdge& e) { return e.object == 2; });
  truth.edges.push_back({20, 2, EdgeKind::depth, true, circle});
  frame = frame_truth(truth, desk_masks(), {});
  for (Surface& surface : prediction.surfaces) surface.grasps.clear();
  Grasp grasp;
  grasp.contacts_px = {ImagePoint{101, 60}, ImagePoint{129, 60}};
  prediction.surfaces[2].grasps = {grasp};
  EXPECT_EQ(score().objects_by_grasp, (Tally{1, 2}));
  prediction.surfaces[2].grasps[0].contacts_px[1] = {101, 62};
  EXPECT_EQ(score().objects_by_grasp, (Tally{0, 2}));
}

}  // namespace
}  // namespace facet
