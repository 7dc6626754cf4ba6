#include "paper/paper_numbers.hpp"

#include <gtest/gtest.h>

#include "synth/table2.hpp"

namespace facet {
namespace {

TEST(PaperTable2, ItsColumnsAddUpToTheTotalsThatThePaperPrints) {
  int objects = 0, objects_19 = 0, surfaces = 0, edges = 0, found = 0, edges_19 = 0;
  for (const PaperScene& scene : paper_table2) {
    objects += scene.objects;
    objects_19 += scene.objects_19;
    surfaces += scene.surfaces;
    edges += scene.edges;
    found += scene.edges_found;
    edges_19 += scene.edges_19;
  }
  EXPECT_EQ(objects, 52);
  EXPECT_NEAR(100.0 * objects_19 / objects, 92.31, 0.005);
  EXPECT_EQ(surfaces, 102);
  EXPECT_NEAR(100.0 * paper_surfaces_19 / surfaces, 77.45, 0.005);
  EXPECT_NEAR(100.0 * found / edges, 98.25, 0.005);
  EXPECT_NEAR(100.0 * edges_19 / edges, 77.73, 0.005);
}

TEST(PaperTable2, OurScenesHoldWhatItsRowsHold) {
  ASSERT_EQ(table2_rows().size(), paper_table2.size());
  for (std::size_t i = 0; i < paper_table2.size(); ++i) {
    const GraspCounts& counts = table2_rows()[i].counts;
    EXPECT_EQ(counts.objects, paper_table2[i].objects) << i;
    EXPECT_EQ(counts.surfaces, paper_table2[i].surfaces) << i;
    EXPECT_EQ(counts.edges, paper_table2[i].edges) << i;
  }
}

}  // namespace
}  // namespace facet
