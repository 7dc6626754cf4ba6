#include "score/clutter.hpp"

#include <gtest/gtest.h>

#include "score/desk.hpp"

namespace facet {
namespace {

TEST(Clutter, OfTwoBoxesApartHasNoOcclusionAndNoContact) {
  const Clutter c = clutter_of(frame_truth(desk(), {}, {}));
  EXPECT_EQ(c.objects, 2);
  EXPECT_EQ(c.surfaces, 3);
  EXPECT_EQ(c.occluded_share, 0);
  EXPECT_EQ(c.contacts, 0);
}

TEST(Clutter, SharesTheDepthEdgesBehindWhichAnotherObjectGoesOn) {
  Truth truth = desk();
  truth.surfaces.push_back({.number = 4, .object = 3, .parts = {{rectangle(70, 20, 90, 80), 20}}});
  const Clutter c = clutter_of(frame_truth(truth, {}, {}));
  // Samples of depth edges: 40 + 60 + 60 and 30 + 60 + 60; the right edge of box 1 and the last three samples
  // of its top edge, whose upper side stays free, have the new face near: the former alone on the outer side.
  EXPECT_NEAR(c.occluded_share, 60.0 / 310, 1e-12);
}

TEST(Clutter, CountsConcaveEdgesAlongAnotherObject) {
  Truth truth = desk();
  truth.surfaces.push_back({.number = 4, .object = 3, .parts = {{rectangle(30, 82, 70, 110), 20}}});
  EXPECT_EQ(clutter_of(frame_truth(truth, {}, {})).contacts, 1);  // 3 px from the foot of box 1
  truth.surfaces.back().parts = {{rectangle(30, 83, 70, 110), 20}};
  EXPECT_EQ(clutter_of(frame_truth(truth, {}, {})).contacts, 0);
}

TEST(Clutter, OfMasksAloneIsTheirNumber) {
  EXPECT_EQ(clutter_of(frame_truth(desk_masks(), {})).objects, 2);
}

}  // namespace
}  // namespace facet
