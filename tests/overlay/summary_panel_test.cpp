#include "overlay/summary_panel.hpp"

#include <gtest/gtest.h>

#include "overlay/example_frame.hpp"

namespace facet {
namespace {

TEST(SummaryPanel, tells_what_was_found) {
  const Size size{64, 48};
  Frame frame = example_frame(size);
  frame.missing_px = 64 * 12;
  Prediction prediction = half_prediction(size);
  prediction.edges(1, 1) = 1;
  prediction.edges(2, 1) = 17;
  prediction.edges(3, 1) = 3;
  prediction.rejected = {{{0, 0}, 5, "too_small"}, {{9, 9}, 6, "too_small"}, {{5, 5}, 7, "sliver"}};
  prediction.note = "a note";
  const std::vector<std::string> expected{"example",
                                          "",
                                          "64 x 48 px, fx 64.0 px",
                                          "depth 1.00 to 1.00 m, 25.0 % missing",
                                          "1 surfaces: 1 with a pose, 0 with a grasp, 0 curved",
                                          "edge pixels: 2 depth, 0 convex, 1 concave",
                                          "3 regions dropped",
                                          "    sliver: 1",
                                          "    too_small: 2",
                                          "a note"};
  EXPECT_EQ(summary_lines(frame, prediction), expected);
}

TEST(SummaryPanel, counts_objects_where_surfaces_are_grouped) {
  const Size size{64, 48};
  Prediction prediction = half_prediction(size);
  prediction.surfaces[0].object = 1;
  EXPECT_EQ(summary_lines(example_frame(size), prediction)[5], "1 objects");
}

TEST(SummaryPanel, says_where_edges_are_not_provided) {
  Prediction prediction = empty_prediction({4, 3});
  prediction.edges = Image<std::uint8_t>();
  EXPECT_EQ(summary_lines(example_frame({4, 3}), prediction)[5], "edges: not provided");
}

}  // namespace
}  // namespace facet
