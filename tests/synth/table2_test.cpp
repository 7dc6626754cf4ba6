#include "synth/table2.hpp"

#include <gtest/gtest.h>

namespace facet {
namespace {

TEST(Table2, RowsAddUpToThePapersTotals) {
  GraspCounts sum;
  for (const Table2Row& row : table2_rows()) {
    sum.objects += row.counts.objects, sum.surfaces += row.counts.surfaces, sum.edges += row.counts.edges;
  }
  EXPECT_EQ(sum, (GraspCounts{52, 102, 229}));
}

TEST(Table2, EveryRowIsFoundWithItsExactCountsForFiveSeeds) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    for (const Table2Row& row : table2_rows()) {
      const Layout layout = table2_layout(row, seed, kinect_v1_camera(), kinect_v1_size());
      const PosedScene posed(layout.view.scene, layout.view.T_world_camera);
      const Rendering exact = render(posed, kinect_v1_camera(), kinect_v1_size());
      EXPECT_EQ(grasp_counts(scene_truth(layout.view, posed, exact, kinect_v1_camera())), row.counts)
          << row.name;
      if (row.kind == "Mixed HC") {
        EXPECT_GE(interacting_share(layout, exact), 0.5);
      }
    }
  }
}

}  // namespace
}  // namespace facet
