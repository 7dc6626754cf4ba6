#include <gtest/gtest.h>

#include "cpu/cpu_pipeline.hpp"
#include "dataset/osd.hpp"
#include "pipeline/modes.hpp"
#include "support/real_data.hpp"

namespace facet {
namespace {

std::unique_ptr<Dataset> osd() {
  return open_osd({.name = "osd",
                   .reader = "osd",
                   .root = real_data_root() / "osd",
                   .frames = {},
                   .kinds = {},
                   .annotations = {},
                   .options = {}});
}

int labelled_pixels(const FrameResult& result) {
  int count = 0;
  for (int y = 0; y < result.labels.height(); ++y)
    for (int x = 0; x < result.labels.width(); ++x) count += result.labels(x, y) > 0;
  return count;
}

TEST(RealFrames, TheDefaultPipelineFindsAHandfulOfSurfacesInEveryOsdFrame) {
  FACET_REQUIRE_DATA("osd");
  const auto data = osd();
  ASSERT_GT(data->size(), 0u);
  for (std::size_t i = 0; i < data->size(); ++i) {
    const Frame frame = data->load(i);
    FrameResult result;
    make_cpu_pipeline({}, 1)->process({frame.depth_m.view(), frame.camera}, result);
    EXPECT_GE(result.surfaces.size(), 4u) << frame.id;
    EXPECT_LE(result.surfaces.size(), 150u) << frame.id;
    EXPECT_GT(labelled_pixels(result), 640 * 480 / 2) << frame.id;
    int posed = 0;
    for (const Surface& surface : result.surfaces) posed += surface.pose.has_value();
    EXPECT_GE(posed, 0.9 * static_cast<double>(result.surfaces.size())) << frame.id;
  }
}

TEST(RealFrames, AGripperOf10CmHasSeveralGraspsInEveryOsdFrame) {
  FACET_REQUIRE_DATA("osd");
  const auto data = osd();
  for (std::size_t i = 0; i < data->size(); ++i) {
    const Frame frame = data->load(i);
    FrameResult result;
    make_cpu_pipeline({}, 1)->process({frame.depth_m.view(), frame.camera}, result);
    int taken = 0;
    for (const Surface& surface : result.surfaces) {
      taken += !surface.grasps.empty();
      for (const Grasp& grasp : surface.grasps) {
        EXPECT_GE(grasp.width_m, 0.005f) << frame.id << ", surface " << surface.id;
        EXPECT_LE(grasp.width_m, 0.1f) << frame.id << ", surface " << surface.id;
        EXPECT_NEAR(norm(grasp.closing_axis), 1, 1e-5f) << frame.id << ", surface " << surface.id;
      }
    }
    EXPECT_GE(taken, 3) << frame.id;
  }
}

TEST(RealFrames, EveryModeYieldsConsistentSurfacesOnEveryOsdFrame) {
  FACET_REQUIRE_DATA("osd");
  const auto data = osd();
  for (std::size_t i = 0; i < data->size(); ++i) {
    const Frame frame = data->load(i);
    for (const Mode& mode : modes) {
      FrameResult result;
      make_cpu_pipeline(mode.params, 1)->process({frame.depth_m.view(), frame.camera}, result);
      EXPECT_FALSE(result.surfaces.empty()) << mode.name << " on " << frame.id << ": " << result.note;
      std::vector<int> area(result.surfaces.size() + 1, 0);
      for (int y = 0; y < result.labels.height(); ++y)
        for (int x = 0; x < result.labels.width(); ++x) {
          ASSERT_LT(result.labels(x, y), area.size()) << mode.name << " on " << frame.id;
          ++area[result.labels(x, y)];
        }
      for (const Surface& surface : result.surfaces) {
        ASSERT_EQ(surface.area_px, area[static_cast<std::size_t>(surface.id)])
            << mode.name << " on " << frame.id;
        ASSERT_NE(surface.pose.has_value(), !surface.no_pose_reason.empty())
            << mode.name << " on " << frame.id;
      }
    }
  }
}

}  // namespace
}  // namespace facet
