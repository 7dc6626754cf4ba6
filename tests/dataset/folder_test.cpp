#include "dataset/folder.hpp"

#include <gtest/gtest.h>

#include "dataset/image_folder.hpp"
#include "file/file_bytes.hpp"
#include "support/expect_error.hpp"

namespace facet {
namespace {

class FolderReader : public ::testing::Test {
 protected:
  FolderReader() {
    spec_.name = "mine";
    spec_.reader = "folder";
    spec_.root = folder_.path();
  }
  void write_yaml(std::string_view text) { write_file_atomically(folder_.path() / "dataset.yaml", text); }
  std::unique_ptr<Dataset> open() const { return open_dataset(spec_); }
  void expect_load_error(const std::string& part) const {
    const auto data = open();
    expect_error(ErrorKind::data, part, [&] { data->load(0); });
  }

  ImageFolder folder_;
  DatasetSpec spec_;
  const std::string minimal_ = "depth: '{id}.png'\ndepth_unit_m: 0.001\nintrinsics: [30, 30, 15.5, 11.5]\n";
};

TEST_F(FolderReader, reads_what_its_dataset_yaml_describes) {
  write_yaml(
      "depth: depth/{id}.png\ncolor: rgb/{id}.png\nregistered: true\ndepth_unit_m: 0.0002\n"
      "intrinsics_file: K.txt\nmissing_codes: [65535]\nsequence: true\nsensor: azure_kinect\n");
  write_file_atomically(folder_.path() / "K.txt", std::string_view("30 0 15.5 0 31 11.5 0 0 1"));
  folder_.write_depth("depth/2.png", 5000);
  folder_.write_depth("depth/10.png", 65535);
  folder_.write_color("rgb/2.png");
  folder_.write_color("rgb/10.png");
  const auto data = open();
  ASSERT_EQ(data->size(), 2u);
  EXPECT_EQ(data->name(), "mine");
  EXPECT_TRUE(data->is_sequence());
  EXPECT_EQ(data->sensor(), Sensor::azure_kinect);
  const Frame frame = data->load(0);
  EXPECT_EQ(frame.id, "2");
  EXPECT_FLOAT_EQ(frame.depth_m(0, 0), 1.0f);
  EXPECT_EQ(frame.camera, (Camera{30, 31, 15.5f, 11.5f}));
  EXPECT_EQ(frame.color.cols, 32);
  EXPECT_EQ(data->load(1).missing_px, 32u * 24u);
}

TEST_F(FolderReader, needs_no_file_in_the_folder_when_the_spec_says_it_all) {
  folder_.write_depth("a.png", 1000);
  spec_.options = {{"depth", "{id}.png"}, {"depth_unit_m", "0.001"}, {"intrinsics", "30,30,15.5,11.5"}};
  EXPECT_FLOAT_EQ(open()->load(0).depth_m(3, 3), 1.0f);
}

TEST_F(FolderReader, lets_the_spec_override_the_folder) {
  folder_.write_depth("a.png", 1000);
  write_yaml(minimal_ + "sensor: stereo\n");
  spec_.options = {{"depth_unit_m", "0.002"}};
  spec_.sensor = Sensor::kinect_v1;
  EXPECT_FLOAT_EQ(open()->load(0).depth_m(0, 0), 2.0f);
  EXPECT_EQ(open()->sensor(), Sensor::kinect_v1);
}

TEST_F(FolderReader, reads_float_tiff) {
  write_yaml("depth: '{id}.tiff'\ndepth_unit_m: 1\nintrinsics: [30, 30, 15.5, 11.5]\n");
  folder_.write("a.tiff", cv::Mat(24, 32, CV_32F, cv::Scalar(1.125)));
  EXPECT_EQ(open()->load(0).depth_m(31, 23), 1.125f);
}

TEST_F(FolderReader, leaves_colour_that_is_not_registered_alone) {
  folder_.write_depth("a.png", 1000);
  folder_.write_color("a.jpg", 99, 11);
  write_yaml(minimal_ + "color: '{id}.jpg'\n");
  const Frame frame = open()->load(0);
  EXPECT_TRUE(frame.color.empty());
  EXPECT_EQ(frame.files.size(), 1u);
}

TEST_F(FolderReader, refuses_registered_colour_of_another_size_or_absent) {
  folder_.write_depth("a.png", 1000);
  write_yaml(minimal_ + "color: '{id}.jpg'\nregistered: true\n");
  expect_load_error("a.jpg: file is missing");
  folder_.write_color("a.jpg", 99, 11);
  expect_load_error("a.jpg: is 99x11 but the depth image is 32x24");
}

TEST_F(FolderReader, names_unit_and_intrinsics_that_cannot_be_right) {
  folder_.write_depth("a.png", 1000);
  write_yaml(minimal_);
  spec_.options = {{"depth_unit_m", "1"}};
  expect_load_error("a.png: the depth unit cannot be right: the median depth would be 1000 m");
  spec_.options = {{"intrinsics", "525,525,319.5,239.5"}};
  expect_load_error("a.png: intrinsics cannot be right");
}

TEST_F(FolderReader, numbered_frames_of_a_known_rate_have_times) {
  write_yaml(minimal_ + "sequence: true\nrate_hz: 10\n");
  for (const char* name : {"5.png", "6.png", "8.png"}) folder_.write_depth(name, 1000);
  const auto data = open();
  EXPECT_TRUE(data->is_sequence());
  EXPECT_DOUBLE_EQ(*data->load(2).timestamp_s, 0.8);
  EXPECT_EQ(data->absent(), std::vector<std::string>{"1 of 4 frames absent, by their numbers"});
}

TEST_F(FolderReader, refuses_a_rate_of_what_is_no_sequence) {
  write_yaml(minimal_ + "rate_hz: 10\n");
  folder_.write_depth("5.png", 1000);
  expect_error(ErrorKind::config, "rate_hz", [&] { open(); });
}

TEST_F(FolderReader, reads_a_frame_of_one_pixel) {
  folder_.write_depth("a.png", 1000, 1, 1);
  write_yaml(minimal_);
  spec_.options = {{"intrinsics", "1,1,0,0"}};
  EXPECT_EQ(open()->load(0).depth_m.size(), (Size{1, 1}));
}

TEST_F(FolderReader, reads_the_other_frames_when_one_is_truncated) {
  for (const char* name : {"a.png", "b.png", "c.png"}) folder_.write_depth(name, 1000);
  folder_.truncate("b.png");
  write_yaml(minimal_);
  const auto data = open();
  EXPECT_EQ(data->load(0).missing_px, 0u);
  expect_error(ErrorKind::data, "b.png: PNG file is truncated", [&] { data->load(1); });
  EXPECT_EQ(data->load(2).missing_px, 0u);
}

TEST_F(FolderReader, refuses_an_empty_or_missing_folder) {
  write_yaml(minimal_);
  expect_error(ErrorKind::data, "no frame of data set 'mine' is here", [&] { open(); });
  spec_.root /= "nowhere";
  expect_error(ErrorKind::data, "nowhere: folder is missing", [&] { open(); });
}

}  // namespace
}  // namespace facet
