#include "prediction/prediction_io.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "file/file_bytes.hpp"
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

namespace facet {
namespace {

Surface planar_surface(int id, int area_px) {
  Surface surface;
  surface.id = id;
  surface.area_px = area_px;
  surface.contour.outer = {{1, 1}, {2, 1}, {2, 3}, {1, 3}};
  surface.contour.holes = {{{1, 2}}};
  surface.plane = Plane{{0.1f, 0.2f, -0.97f}, 1.23456789f};
  surface.inlier_share = 0.93f;
  surface.rms_m = 0.0011f;
  surface.pose = SurfacePose{{0.1f, -0.3f, 1.1f}, {0.5f, 0.5f, -0.5f, 0.5f}, {90, -12.5f, 1e-7f}, {1, 0, 0}};
  surface.graspable = true;
  surface.grasps = {
      {{Vec3{0.1f, 0.2f, 0.9f}, Vec3{0.15f, 0.2f, 0.9f}},
       {{{310.25, 40.5}, {333.0625, -0.5}}},
       {1, 0, 0},
       0.05f,
       0.08f},
      {{Vec3{0.1f, 0.2f, 0.9f}, Vec3{0.1f, 0.3f, 0.9f}}, {{{1, 2}, {3, 4}}}, {0, 1, 0}, 0.1f, 0.0123456789f}};
  return surface;
}

/// Two surfaces of 6 and 4 pixels, the second at the border of the image and without a pose.
Prediction example() {
  Prediction prediction;
  prediction.labels = Image<std::uint16_t>(Size{7, 5}, 0);
  prediction.edges = Image<std::uint8_t>(Size{7, 5}, 0);
  for (int y = 1; y <= 3; ++y) prediction.labels(1, y) = prediction.labels(2, y) = 3;
  for (int y = 0; y < 4; ++y) prediction.labels(6, y) = 300;
  prediction.edges(3, 1) = 1;
  prediction.edges(3, 2) = 18;
  prediction.edges(3, 3) = 3;
  prediction.surfaces = {planar_surface(3, 6), Surface{}};
  prediction.surfaces[0].children = {300};
  Surface& second = prediction.surfaces[1];
  second.id = 300;
  second.area_px = 4;
  second.parent = 3;
  second.object = 17;
  second.curved = true;
  second.touches_border = true;
  second.no_pose_reason = "too few points";
  prediction.rejected = {{{4, 4}, 2, "too small"}};
  prediction.note = "a \"note\"\n";
  return prediction;
}

void expect_equal_images(const Prediction& a, const Prediction& b) {
  ASSERT_EQ(a.labels.size(), b.labels.size());
  ASSERT_EQ(a.edges.size(), b.edges.size());
  for (int y = 0; y < a.labels.height(); ++y) {
    for (int x = 0; x < a.labels.width(); ++x) {
      EXPECT_EQ(a.labels(x, y), b.labels(x, y));
      if (!a.edges.empty()) {
        EXPECT_EQ(a.edges(x, y), b.edges(x, y));
      }
    }
  }
}

void expect_equal_surfaces(const Surface& a, const Surface& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.area_px, b.area_px);
  EXPECT_EQ(a.contour.outer, b.contour.outer);
  EXPECT_EQ(a.contour.holes, b.contour.holes);
  EXPECT_EQ(a.parent, b.parent);
  EXPECT_EQ(a.children, b.children);
  EXPECT_EQ(a.inlier_share, b.inlier_share);
  EXPECT_EQ(a.rms_m, b.rms_m);
  EXPECT_EQ(a.curved, b.curved);
  EXPECT_EQ(a.no_pose_reason, b.no_pose_reason);
  EXPECT_EQ(a.touches_border, b.touches_border);
  EXPECT_EQ(a.graspable, b.graspable);
  EXPECT_EQ(a.object, b.object);
  ASSERT_EQ(a.grasps.size(), b.grasps.size());
  for (std::size_t i = 0; i < a.grasps.size(); ++i) {
    EXPECT_EQ(a.grasps[i].contacts_m, b.grasps[i].contacts_m);
    EXPECT_EQ(a.grasps[i].contacts_px, b.grasps[i].contacts_px);
    EXPECT_EQ(a.grasps[i].closing_axis, b.grasps[i].closing_axis);
    EXPECT_EQ(a.grasps[i].width_m, b.grasps[i].width_m);
    EXPECT_EQ(a.grasps[i].score, b.grasps[i].score);
  }
  ASSERT_EQ(a.plane.has_value(), b.plane.has_value());
  ASSERT_EQ(a.pose.has_value(), b.pose.has_value());
  if (a.plane) {
    EXPECT_EQ(a.plane->normal, b.plane->normal);
    EXPECT_EQ(a.plane->d_m, b.plane->d_m);
  }
  if (a.pose) {
    EXPECT_EQ(a.pose->centre_m, b.pose->centre_m);
    EXPECT_EQ(a.pose->quaternion_wxyz, b.pose->quaternion_wxyz);
    EXPECT_EQ(a.pose->zyx_deg, b.pose->zyx_deg);
    EXPECT_EQ(a.pose->rect_axis, b.pose->rect_axis);
  }
}

TEST(PredictionIo, what_is_written_is_read_back_to_the_last_bit) {
  const TemporaryFolder folder;
  const Prediction written = example();
  write_prediction(written, folder.path() / "new" / "frame");
  const Prediction read = read_prediction(folder.path() / "new" / "frame");
  expect_equal_images(written, read);
  ASSERT_EQ(read.surfaces.size(), 2u);
  for (int i = 0; i < 2; ++i) expect_equal_surfaces(written.surfaces[i], read.surfaces[i]);
  ASSERT_EQ(read.rejected.size(), 1u);
  EXPECT_EQ(read.rejected[0].seed, written.rejected[0].seed);
  EXPECT_EQ(read.rejected[0].area_px, 2);
  EXPECT_EQ(read.rejected[0].reason, "too small");
  EXPECT_EQ(read.note, written.note);
}

TEST(PredictionIo, grasps_of_no_surface_are_read_back) {
  const TemporaryFolder folder;
  Prediction prediction;
  prediction.labels = Image<std::uint16_t>(Size{7, 5}, 0);
  prediction.grasps = {{planar_surface(1, 1).grasps[0], {0.6f, 0, 0.8f}}};
  prediction.grasps.push_back(prediction.grasps[0]);
  prediction.grasps[1].approach_axis.x = std::numeric_limits<float>::quiet_NaN();
  write_prediction(prediction, folder.path() / "f");
  const Prediction read = read_prediction(folder.path() / "f", {7, 5});
  ASSERT_EQ(read.grasps.size(), 1u) << "one that is not finite is left out";
  EXPECT_EQ(read.grasps[0].approach_axis, (Vec3{0.6f, 0, 0.8f}));
  EXPECT_EQ(read.grasps[0].grasp.contacts_m, prediction.grasps[0].grasp.contacts_m);
  EXPECT_TRUE(read.surfaces.empty());
  expect_error(ErrorKind::data, "is 7x5 but the frame is 8x5", [&] {
    read_prediction(folder.path() / "f", {8, 5});
  });
}

TEST(PredictionIo, an_empty_prediction_survives) {
  const TemporaryFolder folder;
  Prediction written;
  written.labels = Image<std::uint16_t>(Size{1, 1}, 0);
  written.note = "no depth at all";
  write_prediction(written, folder.path() / "frame");
  const Prediction read = read_prediction(folder.path() / "frame");
  EXPECT_EQ(read.labels.size(), (Size{1, 1}));
  EXPECT_TRUE(read.edges.empty());
  EXPECT_TRUE(read.surfaces.empty());
  EXPECT_EQ(read.note, "no depth at all");
}

TEST(PredictionIo, the_same_prediction_gives_the_same_bytes_and_no_other_files) {
  const TemporaryFolder folder;
  write_prediction(example(), folder.path() / "a");
  write_prediction(example(), folder.path() / "b");
  const PredictionFiles a(folder.path() / "a"), b(folder.path() / "b");
  EXPECT_EQ(read_file_bytes(a.labels), read_file_bytes(b.labels));
  EXPECT_EQ(read_file_bytes(a.edges), read_file_bytes(b.edges));
  EXPECT_EQ(read_file_bytes(a.surfaces), read_file_bytes(b.surfaces));
  const auto count = std::distance(std::filesystem::directory_iterator(folder.path()), {});
  EXPECT_EQ(count, 6);
}

TEST(PredictionIo, a_frame_id_with_dots_keeps_them) {
  const PredictionFiles files("out/frame.v1.2");
  EXPECT_EQ(files.labels, "out/frame.v1.2.labels.png");
}

TEST(PredictionIo, numbers_that_are_not_finite_become_null_with_a_reason) {
  const TemporaryFolder folder;
  Prediction prediction = example();
  prediction.surfaces[0].rms_m = std::nanf("");
  prediction.surfaces[0].pose->centre_m.y = std::numeric_limits<float>::infinity();
  prediction.surfaces[0].grasps[1].contacts_px[0].x = std::nan("");
  write_prediction(prediction, folder.path() / "frame");
  const auto bytes = read_file_bytes(PredictionFiles(folder.path() / "frame").surfaces);
  const std::string text(bytes.begin(), bytes.end());
  EXPECT_NE(text.find("\"rms_m\":null,\"rms_m_reason\":\"not finite\""), std::string::npos) << text;
  EXPECT_NE(text.find("\"pose\":null,\"pose_reason\":\"not finite\""), std::string::npos) << text;
  EXPECT_NE(text.find("\"grasps\":null,\"grasps_reason\":\"not finite\""), std::string::npos) << text;
  EXPECT_NE(text.find("\"pose\":null,\"pose_reason\":\"too few points\""), std::string::npos) << text;
  EXPECT_NE(text.find("\"rms_m\":null,\"rms_m_reason\":\"no plane was fitted\""), std::string::npos) << text;
  const Prediction read = read_prediction(folder.path() / "frame");
  EXPECT_TRUE(std::isnan(read.surfaces[0].rms_m));
  EXPECT_EQ(read.surfaces[0].no_pose_reason, "not finite");
  EXPECT_TRUE(read.surfaces[0].grasps.empty());
}

TEST(PredictionIo, text_that_is_not_utf8_does_not_stop_the_writer) {
  const TemporaryFolder folder;
  Prediction prediction = example();
  prediction.note = "caf\xE9";
  write_prediction(prediction, folder.path() / "frame");
  EXPECT_EQ(read_prediction(folder.path() / "frame").note, "caf%E9");
}

TEST(PredictionIo, edges_of_an_earlier_prediction_do_not_stay_behind) {
  const TemporaryFolder folder;
  write_prediction(example(), folder.path() / "frame");
  Prediction without_edges = example();
  without_edges.edges = Image<std::uint8_t>();
  write_prediction(without_edges, folder.path() / "frame");
  EXPECT_TRUE(read_prediction(folder.path() / "frame").edges.empty());
}

TEST(PredictionIo, a_place_that_cannot_be_written_is_an_internal_error) {
  const TemporaryFolder folder;
  write_file_atomically(folder.path() / "file", std::string_view("x"));
  expect_error(ErrorKind::internal, "folder cannot be made",
               [&] { write_prediction(example(), folder.path() / "file" / "frame"); });
  expect_error(ErrorKind::internal, "no label image", [&] { write_prediction({}, folder.path() / "frame"); });
}

}  // namespace
}  // namespace facet
