#include "dataset/tum.hpp"

#include <gtest/gtest.h>

#include "dataset/image_folder.hpp"
#include "file/file_bytes.hpp"
#include "support/expect_error.hpp"

namespace facet {
namespace {

class TumReader : public ::testing::Test {
 protected:
  TumReader() {
    spec_.name = "mine";
    spec_.reader = "tum";
    spec_.root = folder_.path();
    spec_.options = {{"intrinsics", "30,30,15.5,11.5"}};
    for (const char* time : {"1.00", "1.03", "1.07"}) {
      folder_.write_depth(std::string("depth/") + time + ".png", 5000);
      folder_.write_color(std::string("rgb/") + time + ".png");
    }
    write("depth.txt", "# depth maps\n1.00 depth/1.00.png\n1.03 depth/1.03.png\n1.07 depth/1.07.png\n");
    write("rgb.txt", "1.01 rgb/1.00.png\n1.035 rgb/1.03.png\n1.20 rgb/1.07.png\n");
    write("groundtruth.txt", "0.995 0 0 0 0 0 0 1\n1.005 0.1 0 0 0 0 0 1\n1.04 0.2 0 0 0 0 0 1\n");
  }
  void write(const char* name, std::string_view text) { write_file_atomically(folder_.path() / name, text); }

  ImageFolder folder_;
  DatasetSpec spec_;
};

TEST_F(TumReader, reads_frames_with_their_times_colours_and_poses) {
  const auto data = open_dataset(spec_);
  EXPECT_TRUE(data->is_sequence());
  EXPECT_EQ(data->sensor(), Sensor::kinect_v1);
  ASSERT_EQ(data->size(), 3u);
  const Frame first = data->load(0);
  EXPECT_EQ(first.id, "1.00");
  EXPECT_FLOAT_EQ(first.depth_m(0, 0), 1.0f);
  EXPECT_EQ(first.timestamp_s, 1.00);
  EXPECT_EQ(first.color.cols, 32);
  ASSERT_TRUE(first.T_world_camera);
  EXPECT_NEAR(first.T_world_camera->origin.x, 0.05, 1e-9);
  EXPECT_FALSE(data->load(1).T_world_camera);  // 25 ms after the pose before it
  EXPECT_TRUE(data->load(2).color.empty());
}

TEST_F(TumReader, says_what_has_no_partner) {
  EXPECT_EQ(open_dataset(spec_)->absent(),
            (std::vector<std::string>{"1 entry of depth.txt without colour within 20 ms",
                                      "1 entry of rgb.txt left out: no depth within 20 ms"}));
  spec_.options["tolerance_s"] = "0.2";
  EXPECT_TRUE(open_dataset(spec_)->absent().empty());
}

TEST_F(TumReader, says_how_many_entries_it_leaves_out) {
  write("depth.txt",
        "1.07 depth/1.07.png\n1.00 depth/1.00.png\n1.00 depth/1.03.png\n2 depth/2.png\nrubbish\n");
  const auto data = open_dataset(spec_);
  ASSERT_EQ(data->size(), 2u);
  EXPECT_EQ(data->frame_id(0), "1.00");
  const std::vector<std::string> remarks = data->absent();
  ASSERT_GE(remarks.size(), 4u);
  EXPECT_EQ(remarks[0], "1 entry of depth.txt left out: not a time and a file");
  EXPECT_EQ(remarks[1], "1 entry of depth.txt left out: the file is missing");
  EXPECT_EQ(remarks[2], "1 entry of depth.txt left out: the time or the file stands there before");
  EXPECT_EQ(remarks[3], "1 entry of depth.txt out of order, put in order");
}

TEST_F(TumReader, needs_neither_colour_nor_trajectory) {
  std::filesystem::remove(folder_.path() / "rgb.txt");
  std::filesystem::remove(folder_.path() / "groundtruth.txt");
  const auto data = open_dataset(spec_);
  const Frame frame = data->load(0);
  EXPECT_TRUE(frame.color.empty());
  EXPECT_FALSE(frame.T_world_camera);
  EXPECT_NE(data->description().find("3 frames in 0.07 s, 0 with colour, 0 with a pose"), std::string::npos)
      << data->description();
}

TEST_F(TumReader, a_truncated_image_fails_its_own_frame) {
  folder_.truncate("depth/1.03.png");
  const auto data = open_dataset(spec_);
  EXPECT_EQ(data->load(0).missing_px, 0u);
  expect_error(ErrorKind::data, "1.03.png", [&] { data->load(1); });
  EXPECT_EQ(data->load(2).missing_px, 0u);
}

TEST_F(TumReader, reads_selected_frames_and_refuses_unknown_ones) {
  spec_.frames = {"1.07"};
  const auto data = open_dataset(spec_);
  ASSERT_EQ(data->size(), 1u);
  EXPECT_EQ(data->load(0).timestamp_s, 1.07);
  spec_.frames = {"9"};
  expect_error(ErrorKind::data, "has no frame 9", [&] { open_dataset(spec_); });
}

TEST_F(TumReader, finds_truth_beside_a_frame) {
  write("depth/1.03.json",
        R"({"version": "5.0.1", "flags": {"pixel_centres": true}, "imagePath": "x", "imageData": null,
            "imageHeight": 24, "imageWidth": 32, "shapes": [{"label": "surface/1", "group_id": 1, "shape_type":
            "polygon", "flags": {"graspable": true}, "points": [[2, 2], [20, 2], [20, 20], [2, 20]]}]})");
  const auto data = open_dataset(spec_);
  EXPECT_FALSE(data->annotation(0, data->load(0)));
  const auto found = data->annotation(1, data->load(1));
  ASSERT_TRUE(found);
  ASSERT_TRUE(found->truth);
  EXPECT_EQ(found->truth->surfaces.size(), 1u);
}

TEST_F(TumReader, refuses_a_folder_of_another_layout) {
  std::filesystem::remove(folder_.path() / "depth.txt");
  EXPECT_FALSE(is_tum(folder_.path()));
  expect_error(ErrorKind::data, "depth.txt", [&] { open_dataset(spec_); });
  spec_.root /= "nowhere";
  expect_error(ErrorKind::data, "nowhere: folder is missing", [&] { open_dataset(spec_); });
  spec_.options["tolerance_s"] = "-1";
  spec_.root = folder_.path();
  expect_error(ErrorKind::config, "tolerance_s", [&] { open_dataset(spec_); });
}

}  // namespace
}  // namespace facet
