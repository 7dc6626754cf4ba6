#include "dataset/osd.hpp"

#include <gtest/gtest.h>

#include "dataset/image_folder.hpp"
#include "support/expect_error.hpp"

namespace facet {
namespace {

/// A folder in the layout of OSD with frames of the size that the assumed camera fits.
class OsdReader : public ::testing::Test {
 protected:
  OsdReader() {
    spec_.name = spec_.reader = "osd";
    spec_.root = folder_.path();
  }
  void write_frame(const std::string& id) {
    folder_.write_depth("disparity/" + id + ".png", 900, 640, 480);
    folder_.write_color("image_color/" + id + ".png", 640, 480);
  }

  ImageFolder folder_;
  DatasetSpec spec_;
};

TEST_F(OsdReader, lists_frames_in_natural_order_and_reads_them) {
  for (const char* id : {"test10", "test9", "learn44"}) write_frame(id);
  folder_.write("annotation/test9.png", cv::Mat(480, 640, CV_8U, cv::Scalar(3)));
  const auto data = open_dataset(spec_);
  ASSERT_EQ(data->size(), 3u);
  EXPECT_EQ(data->frame_id(0), "learn44");
  EXPECT_EQ(data->frame_id(1), "test9");
  EXPECT_EQ(data->frame_id(2), "test10");
  EXPECT_EQ(data->sensor(), Sensor::kinect_v1);
  EXPECT_FALSE(data->is_sequence());
  const Frame frame = data->load(1);
  EXPECT_EQ(frame.id, "test9");
  EXPECT_FLOAT_EQ(frame.depth_m(639, 479), 0.9f);
  EXPECT_EQ(frame.color.at<cv::Vec3b>(0, 0), cv::Vec3b(10, 20, 30));
  EXPECT_EQ(frame.camera, (Camera{525, 525, 319.5f, 239.5f}));
  ASSERT_TRUE(frame.object_masks.has_value());
  EXPECT_EQ(frame.object_masks->at<std::uint16_t>(5, 5), 3);
  EXPECT_EQ(frame.files.size(), 3u);
  EXPECT_FALSE(data->load(2).object_masks.has_value());
}

TEST_F(OsdReader, takes_selection_sensor_and_intrinsics_from_the_spec) {
  write_frame("test0");
  write_frame("test1");
  spec_.frames = {"test1"};
  spec_.sensor = Sensor::stereo;
  spec_.options["intrinsics"] = "600,601,320,240";
  const auto data = open_dataset(spec_);
  ASSERT_EQ(data->size(), 1u);
  EXPECT_EQ(data->sensor(), Sensor::stereo);
  EXPECT_EQ(data->load(0).camera, (Camera{600, 601, 320, 240}));
}

TEST_F(OsdReader, keeps_a_frame_whose_depth_is_lost_as_a_frame_that_fails) {
  write_frame("test0");
  folder_.write_color("image_color/test1.png", 640, 480);
  const auto data = open_dataset(spec_);
  ASSERT_EQ(data->size(), 2u);
  EXPECT_EQ(data->load(0).missing_px, 0u);
  expect_error(ErrorKind::data, "disparity/test1.png: file is missing", [&] { data->load(1); });
}

TEST_F(OsdReader, names_every_broken_file_of_a_frame_at_once) {
  write_frame("test0");
  folder_.truncate("disparity/test0.png");
  folder_.truncate("image_color/test0.png");
  folder_.write("annotation/test0.png", cv::Mat(4, 4, CV_8UC3, cv::Scalar(1)));
  const auto data = open_dataset(spec_);
  for (const char* part :
       {"disparity/test0.png: PNG file is truncated", "image_color/test0.png: PNG file is truncated",
        "annotation/test0.png: object masks must be"})
    expect_error(ErrorKind::data, part, [&] { data->load(0); });
}

TEST_F(OsdReader, refuses_colour_of_another_size) {
  write_frame("test0");
  folder_.write_color("image_color/test0.png", 320, 240);
  const auto data = open_dataset(spec_);
  expect_error(ErrorKind::data, "is 320x240 but the depth image is 640x480", [&] { data->load(0); });
}

TEST_F(OsdReader, reads_a_frame_without_any_depth) {
  write_frame("test0");
  folder_.write_depth("disparity/test0.png", 0, 640, 480);
  EXPECT_EQ(open_dataset(spec_)->load(0).missing_px, 640u * 480u);
}

TEST_F(OsdReader, says_that_the_depth_is_a_download_of_its_own) {
  folder_.write_color("image_color/test0.png");
  expect_error(ErrorKind::data, "OSD-0.2-depth.zip", [&] { open_dataset(spec_); });
}

TEST_F(OsdReader, refuses_an_empty_or_missing_folder) {
  std::filesystem::create_directories(folder_.path() / "image_color");
  std::filesystem::create_directories(folder_.path() / "disparity");
  expect_error(ErrorKind::data, "no frame of data set 'osd' is here", [&] { open_dataset(spec_); });
  spec_.root /= "nowhere";
  expect_error(ErrorKind::data, "nowhere/disparity: folder is missing", [&] { open_dataset(spec_); });
}

}  // namespace
}  // namespace facet
