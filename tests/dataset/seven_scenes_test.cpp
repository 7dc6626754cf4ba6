#include "dataset/seven_scenes.hpp"

#include <gtest/gtest.h>

#include "dataset/image_folder.hpp"
#include "file/file_bytes.hpp"
#include "support/expect_error.hpp"

namespace facet {
namespace {

class SevenScenesReader : public ::testing::Test {
 protected:
  SevenScenesReader() {
    spec_.name = "mine";
    spec_.reader = "seven_scenes";
    spec_.root = folder_.path();
    spec_.options = {{"intrinsics", "30,30,15.5,11.5"}};
    for (const char* number : {"000002", "000003", "000010"}) {
      folder_.write_depth(std::string("frame-") + number + ".depth.png", 1500);
      write_pose(number, "1 0 0 0.5\n0 1 0 0\n0 0 1 0\n0 0 0 1\n");
    }
  }
  void write_pose(const std::string& number, std::string_view text) {
    write_file_atomically(folder_.path() / ("frame-" + number + ".pose.txt"), text);
  }

  ImageFolder folder_;
  DatasetSpec spec_;
};

TEST_F(SevenScenesReader, reads_frames_with_their_times_and_poses) {
  const auto data = open_dataset(spec_);
  EXPECT_TRUE(data->is_sequence());
  ASSERT_EQ(data->size(), 3u);
  const Frame frame = data->load(1);
  EXPECT_EQ(frame.id, "000003");
  EXPECT_FLOAT_EQ(frame.depth_m(0, 0), 1.5f);
  EXPECT_DOUBLE_EQ(*frame.timestamp_s, 0.1);
  EXPECT_EQ(frame.T_world_camera->origin.x, 0.5);
  EXPECT_TRUE(frame.color.empty());
  EXPECT_EQ(data->absent(), std::vector<std::string>{"6 of 9 frames absent, by their numbers"});
}

TEST_F(SevenScenesReader, takes_65535_for_missing_depth) {
  folder_.write_depth("frame-000002.depth.png", 65535);
  EXPECT_EQ(open_dataset(spec_)->load(0).missing_px, 32u * 24u);
}

TEST_F(SevenScenesReader, counts_poses_that_are_lost) {
  write_pose("000002", "-1.#IND 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n");
  std::filesystem::remove(folder_.path() / "frame-000010.pose.txt");
  const auto data = open_dataset(spec_);
  EXPECT_FALSE(data->load(0).T_world_camera);
  EXPECT_TRUE(data->load(1).T_world_camera);
  EXPECT_FALSE(data->load(2).T_world_camera);
  const std::vector<std::string> remarks = data->absent();
  ASSERT_EQ(remarks.size(), 3u);
  EXPECT_EQ(remarks[1], "1 entry without a file of the pose");
  EXPECT_EQ(remarks[2], "1 entry whose file of the pose holds none");
}

TEST_F(SevenScenesReader, is_told_by_its_files) {
  EXPECT_TRUE(is_seven_scenes(folder_.path()));
  EXPECT_FALSE(is_seven_scenes(folder_.path() / "nowhere"));
  write_file_atomically(folder_.path() / "dataset.yaml", std::string_view("depth: x"));
  EXPECT_FALSE(is_seven_scenes(folder_.path()));
}

TEST_F(SevenScenesReader, refuses_an_empty_folder) {
  const ImageFolder empty;
  spec_.root = empty.path();
  expect_error(ErrorKind::data, "no frame of data set 'mine' is here", [&] { open_dataset(spec_); });
}

}  // namespace
}  // namespace facet
