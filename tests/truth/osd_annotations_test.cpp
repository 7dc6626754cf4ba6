// The annotations of real frames below FACET_DATA keep every rule; skipped where they are absent.
#include <gtest/gtest.h>

#include "support/real_data.hpp"
#include "truth/annotation.hpp"
#include "truth/truth_map.hpp"

namespace facet {
namespace {

TEST(OsdAnnotations, FollowEveryRuleAndCoverTheirSurfaces) {
  FACET_REQUIRE_DATA("osd/truth");
  const struct {
    const char* name;
    std::size_t surfaces, edges;
  } frames[] = {{"learn6", 4, 15}, {"test42", 6, 17}, {"test63", 35, 89}};
  for (const auto& frame : frames) {
    const Truth truth =
        read_annotation(real_data_root() / "osd/truth" / (std::string(frame.name) + ".json"), {640, 480});
    EXPECT_EQ(truth.surfaces.size(), frame.surfaces) << frame.name;
    EXPECT_EQ(truth.edges.size(), frame.edges) << frame.name;
    const TruthMap map = rasterise(truth, {}, {});
    for (std::size_t k = 0; k < truth.surfaces.size(); ++k)
      EXPECT_GT(map.area_px[k], 0) << truth.surfaces[k].number;
  }
}

}  // namespace
}  // namespace facet
