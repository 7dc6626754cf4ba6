#include <gtest/gtest.h>

#include "cpu/cpu_pipeline.hpp"
#include "pipeline/face_match.hpp"
#include "pipeline/modes.hpp"
#include "synth/synthetic_frame.hpp"

namespace facet {
namespace {

FrameResult processed(const PipelineParams& params, const SyntheticFrame& frame) {
  FrameResult result;
  make_cpu_pipeline(params, 1)->process({frame.depth_m.view(), frame.camera}, result);
  return result;
}

SyntheticFrame exact_frame(const std::string& scenes, std::size_t index) {
  return make_frame({.scenes = scenes, .noise_free = true}, index);
}

TEST(ExactScenes, TheNaivePipelineFindsEveryFaceOfABoxOnAPlane) {
  const SyntheticFrame frame = exact_frame("plane_and_box", 0);
  const auto faces = match_faces(frame.exact.surface_ids, processed(naive_params(), frame).labels);
  ASSERT_EQ(faces.size(), 4u);
  EXPECT_TRUE(all_found(faces, 0.8)) << describe(faces);
}

TEST(ExactScenes, TheDefaultPipelineFindsEveryFaceOfABoxOnAPlaneAndNothingElse) {
  const SyntheticFrame frame = exact_frame("plane_and_box", 0);
  const FrameResult result = processed({}, frame);
  const auto faces = match_faces(frame.exact.surface_ids, result.labels);
  EXPECT_TRUE(all_found(faces, 0.9)) << describe(faces);
  EXPECT_EQ(result.surfaces.size(), 4u);
}

TEST(ExactScenes, TheDefaultPipelineFindsNearlyEveryFaceOfTheQuickstartScenes) {
  int found = 0, all = 0;
  for (std::size_t i = 0; i < frame_ids({}).size(); ++i) {
    const SyntheticFrame frame = exact_frame("quickstart", i);
    const auto faces = match_faces(frame.exact.surface_ids, processed({}, frame).labels);
    for (const FaceMatch& face : faces) {
      ++all;
      found += face.iou >= 0.8;
    }
  }
  RecordProperty("found", found);
  RecordProperty("faces", all);
  EXPECT_GE(found, 0.9 * all) << found << " of " << all << " faces";
}

TEST(ExactScenes, TheDefaultPipelinesPosesAreThoseOfTheFaces) {
  const SyntheticFrame frame = exact_frame("plane_and_box", 0);
  const FrameResult result = processed({}, frame);
  const PosedScene posed(frame.view.scene, frame.view.T_world_camera);
  const SceneTruth truth = scene_truth(frame.view, posed, frame.exact, frame.camera);
  int compared = 0;
  for (const FaceMatch& match : match_faces(frame.exact.surface_ids, result.labels))
    for (const TrueFace& face : truth.faces) {
      if (face.surface_id != match.surface_id || !face.plane) continue;
      const Surface& surface = result.surfaces[static_cast<std::size_t>(match.label) - 1];
      ASSERT_TRUE(surface.plane && surface.pose) << surface.no_pose_reason;
      EXPECT_GT(dot(surface.plane->normal, face.plane->normal), 0.99996f)
          << face.name;  // within 0.5 degrees
      EXPECT_NEAR(surface.plane->signed_distance_m(face.centroid_m), 0, 0.001f) << face.name;
      EXPECT_LT(norm(surface.pose->centre_m - face.centroid_m), 0.003f) << face.name;
      EXPECT_FALSE(surface.curved) << face.name;
      ++compared;
    }
  EXPECT_GE(compared, 3);
}

TEST(ExactScenes, ALineFromBorderToBorderSeparatesTwoSurfaces) {
  const auto pipeline = make_cpu_pipeline({}, 1);
  for (int turn_deg = 0; turn_deg < 180; turn_deg += 5) {
    const double c = std::cos(turn_deg * M_PI / 180), s = std::sin(turn_deg * M_PI / 180);
    Image<float> depth({97, 73});
    for (int y = 0; y < 73; ++y)
      for (int x = 0; x < 97; ++x) depth(x, y) = c * (x - 48.3) + s * (y - 36.2) > 0 ? 1.0f : 1.3f;
    FrameResult result;
    pipeline->process({depth.view(), {100, 100, 48, 36}}, result);
    EXPECT_EQ(result.surfaces.size(), 2u) << turn_deg << " degrees";
  }
}

}  // namespace
}  // namespace facet
