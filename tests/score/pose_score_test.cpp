#include "score/pose_score.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "score/desk.hpp"
#include "score/truth_prediction.hpp"

namespace facet {
namespace {

/// A plane that looks at the camera, tilted about its x axis.
TruePose tilted(int surface, double degrees) {
  const auto radians = static_cast<float>(degrees / 57.29577951308232);
  const Vec3 normal{0, -std::sin(radians), -std::cos(radians)}, centre{0.05f, 0.02f, 0.8f};
  return {surface, Plane{normal, -dot(normal, centre)}, centre};
}

TEST(PoseScore, ATiltOfThreeDegreesIsMeasuredAsThreeDegrees) {
  const TruePose truth = tilted(1, 30);
  SurfacePose estimate = pose_of(tilted(1, 33));
  const PoseError error = pose_error(truth, estimate);
  EXPECT_NEAR(error.normal_deg, 3, 1e-4);
  EXPECT_NEAR(error.rotation_deg, 3, 1e-4);
  EXPECT_NEAR(error.offset_m, 0, 1e-7);
}

TEST(PoseScore, AShiftIsTakenApartAlongAndAcrossTheNormal) {
  const TruePose truth = tilted(1, 30);
  SurfacePose estimate = pose_of(truth);
  estimate.centre_m = estimate.centre_m + 0.004f * truth.plane->normal + Vec3{0.003f, 0, 0};
  const PoseError error = pose_error(truth, estimate);
  EXPECT_NEAR(error.offset_m, 0.004, 1e-6);
  EXPECT_NEAR(error.lateral_m, 0.003, 1e-6);
  EXPECT_NEAR(error.rotation_deg, 0, 1e-4);
  for (float& q : estimate.quaternion_wxyz) q = -q;  // the same rotation
  EXPECT_NEAR(pose_error(truth, estimate).rotation_deg, 0, 1e-4);
}

TEST(PoseScore, SuccessCountsEveryFlatSurfaceAndErrorsTheDetectedOnes) {
  TruePose curved = tilted(3, 0);
  curved.plane.reset();
  const FrameTruth frame = frame_truth(desk(), desk_masks(), {}, {tilted(1, 60), tilted(2, 10), curved});
  Prediction prediction = truth_as_prediction(frame);
  const auto score = [&] {
    return score_poses(frame, compare_regions(frame, frame.surfaces, surface_regions(frame, prediction)),
                       prediction);
  };
  EXPECT_EQ(score().success_5, (Tally{2, 2}));
  EXPECT_NEAR(score().auc_total, 2, 1e-4);
  EXPECT_EQ(score().curved_centre_m.size(), 1u);
  prediction.surfaces[0].pose->centre_m.x += 0.007f;
  EXPECT_EQ(score().success_5, (Tally{1, 2}));
  EXPECT_EQ(score().success_10, (Tally{2, 2}));
  EXPECT_NEAR(score().auc_total, 1.3, 1e-3);
  prediction.surfaces[1].pose.reset();
  EXPECT_EQ(score().success_10, (Tally{1, 2}));
  EXPECT_EQ(score().errors.size(), 1u);
}

}  // namespace
}  // namespace facet
