#include "synth_io/scene_annotation.hpp"

#include <gtest/gtest.h>

#include "synth/families.hpp"
#include "truth/annotation.hpp"
#include "truth/truth_map.hpp"

namespace facet {
namespace {

TEST(SceneAnnotation, ReadBackItGivesExactlyThePixelsOfTheRenderer) {
  const Size size = kinect_v1_size();
  const Camera camera = kinect_v1_camera();
  std::uint64_t k = 0;
  for (const SceneRecipe& family : scene_families()) {
    const View view = random_layout(family, 31, k++, camera, size).view;
    const PosedScene posed(view.scene, view.T_world_camera);
    const Rendering exact = render(posed, camera, size);
    const SceneTruth scene = scene_truth(view, posed, exact, camera);
    const Annotation back = parse_annotation(annotation_text(truth_of(scene, exact), "f.png"), size);
    ASSERT_TRUE(back.problems.empty()) << back.problems[0].rule;
    ASSERT_EQ(back.truth.surfaces.size(), scene.faces.size());
    ASSERT_EQ(back.truth.edges.size(), scene.edges.size());
    const TruthMap map = rasterise(back.truth, exact.object_ids, exact.depth_m);
    for (std::size_t f = 0; f < scene.faces.size(); ++f) {
      EXPECT_EQ(map.area_px[f], scene.faces[f].visible_px);
      EXPECT_EQ(map.surface_counts[f], scene.faces[f].visible_px >= counted_surface_px);
    }
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const int id = exact.surface_ids(x, y), label = map.surfaces(x, y);
        if (label > 0) {
          ASSERT_EQ(scene.faces[static_cast<std::size_t>(label - 1)].surface_id, id);
        }
        ASSERT_EQ(map.regions(x, y) == TruthRegion::support, id == table_surface_id);
      }
    }
    for (std::size_t e = 0; e < scene.edges.size(); ++e) {
      EXPECT_NEAR(length_px(back.truth.edges[e].line), scene.edges[e].length_px, 1.1);
      EXPECT_EQ(back.truth.edges[e].kind, scene.edges[e].kind);
    }
  }
}

}  // namespace
}  // namespace facet
