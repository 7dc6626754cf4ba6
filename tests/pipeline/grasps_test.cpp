// Grasps on rendered scenes, end to end: on the faces that a jaw fits, where they really are.
#include <gtest/gtest.h>

#include "cpu/cpu_pipeline.hpp"
#include "pipeline/face_match.hpp"
#include "synth/shapes.hpp"
#include "synth/synthetic_frame.hpp"

namespace facet {
namespace {

/// One object on a table from above and in front, without noise.
struct OneObject {
  View view{.name = "object", .scene = {}, .T_world_camera = look_at({0.05, -0.45, 0.65}, {0, 0, 0.05})};
  Camera camera = kinect_v1_camera();
  Rendering exact{};
  FrameResult result{};
  std::vector<TrueFace> faces{};

  explicit OneObject(const SceneObject& object, const PipelineParams& params = {}) {
    view.scene.objects = {object};
    const PosedScene posed(view.scene, view.T_world_camera);
    exact = render(posed, camera, kinect_v1_size());
    faces = scene_truth(view, posed, exact, camera).faces;
    make_cpu_pipeline(params, 1)->process({exact.depth_m.view(), camera}, result);
  }
  const std::vector<Grasp>& grasps_on(const std::string& face_name) const {
    static const std::vector<Grasp> none;
    for (const TrueFace& face : faces)
      for (const FaceMatch& match : match_faces(exact.surface_ids, result.labels))
        if (face.name == face_name && match.surface_id == face.surface_id && match.iou > 0.5)
          return result.surfaces[static_cast<std::size_t>(match.label) - 1].grasps;
    ADD_FAILURE() << face_name << " was not found";
    return none;
  }
};

SceneObject turned(SceneObject object, double yaw_deg) {
  object.pose = rotation({0, 0, 1}, yaw_deg * M_PI / 180);
  return object;
}
PipelineParams with_jaw(float max_opening_mm) {
  PipelineParams params;
  params.grasp.max_opening_mm = max_opening_mm;
  return params;
}

TEST(Grasps, ABoxIsTakenAcrossBothWidthsOfItsTop) {
  for (const double yaw_deg : {0.0, 20.0, 45.0, 70.0}) {
    const OneObject scene(turned(make_box({0.09, 0.06, 0.08}), yaw_deg));
    const auto& grasps = scene.grasps_on("box, top");
    ASSERT_EQ(grasps.size(), 2u) << yaw_deg;
    EXPECT_NEAR(grasps[0].width_m, 0.06, 0.004) << yaw_deg;
    EXPECT_NEAR(grasps[1].width_m, 0.09, 0.004) << yaw_deg;
  }
}

TEST(Grasps, AJawThatIsTooSmallTakesOnlyTheNarrowSideOrNothing) {
  const SceneObject box = turned(make_box({0.09, 0.06, 0.08}), 20);
  const auto on_top = [&](float opening_mm) {
    return OneObject(box, with_jaw(opening_mm)).grasps_on("box, top");
  };
  ASSERT_EQ(on_top(75).size(), 1u);
  EXPECT_NEAR(on_top(75)[0].width_m, 0.06, 0.004);
  EXPECT_TRUE(on_top(50).empty());
}

TEST(Grasps, ACylinderIsTakenAcrossItsTopAndByItsSilhouettes) {
  const OneObject scene(make_cylinder(0.035, 0.12));
  for (const char* face : {"cylinder, top", "cylinder, side"}) {
    const auto& grasps = scene.grasps_on(face);
    ASSERT_FALSE(grasps.empty()) << face;
    EXPECT_NEAR(grasps[0].width_m, 0.07, 0.008) << face;
  }
  const OneObject narrow_jaw(make_cylinder(0.035, 0.12), with_jaw(55));
  EXPECT_TRUE(narrow_jaw.grasps_on("cylinder, top").empty());
}

TEST(Grasps, TheTableAndTheRoomAreNotTaken) {
  const OneObject scene(make_box({0.09, 0.06, 0.08}));
  std::map<int, int> object_px;
  for (int y = 0; y < scene.result.labels.height(); ++y)
    for (int x = 0; x < scene.result.labels.width(); ++x)
      object_px[scene.result.labels(x, y)] += scene.exact.surface_ids(x, y) > table_surface_id;
  for (const Surface& surface : scene.result.surfaces)
    if (2 * object_px[surface.id] < surface.area_px) {
      EXPECT_TRUE(surface.grasps.empty()) << surface.id;
    }
}

TEST(Grasps, ContactsLieOnTheBorderOfTheirSurface) {
  for (std::size_t i = 0; i < frame_ids({}).size(); ++i) {
    const SyntheticFrame frame = make_frame({}, i);
    FrameResult result;
    make_cpu_pipeline({}, 1)->process({frame.depth_m.view(), frame.camera}, result);
    for (const Surface& surface : result.surfaces)
      for (const Grasp& grasp : surface.grasps)
        for (const ImagePoint& contact : grasp.contacts_px) {
          double nearest = 1e9;
          for (const ContourPoint& p : surface.contour.outer)
            nearest = std::min(nearest, std::hypot(p.x - contact.x, p.y - contact.y));
          EXPECT_LT(nearest, 4) << frame.id << ", surface " << surface.id;
        }
  }
}

TEST(Grasps, AreLeftOutOnRequest) {
  PipelineParams params;
  params.grasp.enabled = false;
  for (const Surface& surface : OneObject(make_box({0.09, 0.06, 0.08}), params).result.surfaces)
    EXPECT_TRUE(surface.grasps.empty());
}

}  // namespace
}  // namespace facet
