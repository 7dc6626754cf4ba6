#include "dataset/verify.hpp"

#include <gtest/gtest.h>

#include "dataset/image_folder.hpp"
#include "file/file_bytes.hpp"

namespace facet {
namespace {

DatasetSpec folder_spec(const ImageFolder& folder) {
  DatasetSpec spec;
  spec.name = "mine";
  spec.reader = "folder";
  spec.root = folder.path();
  spec.options = {{"depth", "{id}.png"}, {"depth_unit_m", "0.001"}, {"intrinsics", "30,30,15.5,11.5"}};
  return spec;
}

TEST(Verify, sums_up_what_can_be_read) {
  const ImageFolder folder;
  folder.write_depth("a.png", 1000);
  folder.write_depth("b.png", 2000);
  folder.write_depth("c.png", 0, 30, 24);
  const DatasetReport report = verify_dataset(folder_spec(folder));
  EXPECT_TRUE(report.is_whole());
  EXPECT_EQ(report.frames, 3u);
  EXPECT_EQ(report.readable, 3u);
  EXPECT_EQ(report.with_color, 0u);
  ASSERT_EQ(report.image_sizes.size(), 2u);
  EXPECT_EQ(report.image_sizes[0].size, (Size{32, 24}));
  EXPECT_EQ(report.image_sizes[0].frames, 2u);
  EXPECT_FLOAT_EQ(report.nearest_m, 1.0f);
  EXPECT_FLOAT_EQ(report.farthest_m, 2.0f);
  EXPECT_NEAR(report.missing_share, 30.0 / (32 + 32 + 30), 1e-12);
}

TEST(Verify, names_every_frame_that_cannot_be_read) {
  const ImageFolder folder;
  for (const char* name : {"a.png", "b.png", "c.png"}) folder.write_depth(name, 1000);
  folder.truncate("a.png");
  folder.write_depth("c.png", 65000);
  const DatasetReport report = verify_dataset(folder_spec(folder));
  EXPECT_FALSE(report.is_whole());
  EXPECT_EQ(report.readable, 1u);
  ASSERT_EQ(report.problems.size(), 2u);
  EXPECT_EQ(report.problems[0].subject, "a");
  EXPECT_NE(report.problems[0].message.find("a.png: PNG file is truncated"), std::string::npos);
  EXPECT_NE(report.problems[1].message.find("c.png: the depth unit cannot be right"), std::string::npos);
}

TEST(Verify, tells_which_frames_of_osd_are_absent_and_which_files_differ) {
  const ImageFolder folder;
  for (const char* id : {"learn6", "test0"}) {
    folder.write_depth("disparity/" + std::string(id) + ".png", 900, 640, 480);
    folder.write_color("image_color/" + std::string(id) + ".png", 640, 480);
  }
  write_file_atomically(folder.path() / "pcd" / "learn6.pcd", std::string_view("x"));
  DatasetSpec spec;
  spec.name = spec.reader = "osd";
  spec.root = folder.path();
  const DatasetReport report = verify_dataset(spec);
  ASSERT_EQ(report.groups.size(), 2u);
  EXPECT_EQ(report.groups[0].name, "learn");
  EXPECT_EQ(report.groups[0].expected, 45u);
  EXPECT_EQ(report.groups[0].found(), 1u);
  EXPECT_EQ(report.groups[0].absent.front(), "learn0");
  EXPECT_EQ(report.groups[1].expected, 66u);
  EXPECT_EQ(report.groups[1].absent.back(), "test65");
  EXPECT_EQ(report.checksums_compared, 2u);  // depth and colour of learn6
  ASSERT_EQ(report.problems.size(), 2u);
  EXPECT_EQ(report.problems[0].subject, "disparity/learn6.png");
  EXPECT_EQ(report.notes, std::vector<std::string>{"pcd/ has 1 files, which are not read"});
  EXPECT_FALSE(report.is_whole());
}

}  // namespace
}  // namespace facet
