// Reads real recordings below FACET_DATA; skipped where they are absent.
#include "support/real_data.hpp"

#include <gtest/gtest.h>

#include "dataset/verify.hpp"

namespace facet {
namespace {

DatasetSpec spec_of(const std::string& reader, const std::string& folder, const ReaderOptions& options = {}) {
  DatasetSpec spec;
  spec.name = folder;
  spec.reader = reader;
  spec.root = real_data_root() / folder;
  spec.options = options;
  return spec;
}

TEST(RealData, osd_frames_are_the_ones_we_know) {
  FACET_REQUIRE_DATA("osd");
  const DatasetReport report = verify_dataset(spec_of("osd", "osd"));
  EXPECT_TRUE(report.problems.empty()) << report.problems[0].message;
  EXPECT_EQ(report.readable, report.frames);
  EXPECT_EQ(report.with_color, report.frames);
  EXPECT_GE(report.checksums_compared, 9u);
  EXPECT_GT(report.missing_share, 0.1);
  EXPECT_LT(report.missing_share, 0.4);
}

TEST(RealData, a_sequence_of_7_scenes_reads_with_its_poses) {
  FACET_REQUIRE_DATA("seven_scenes");
  const DatasetSpec spec = spec_of("seven_scenes", "seven_scenes");
  const DatasetReport report = verify_dataset(spec);
  EXPECT_TRUE(report.is_whole()) << report.problems[0].message;
  EXPECT_EQ(report.frames, 40u);
  EXPECT_LT(report.farthest_m, 20);
  const auto data = open_dataset(spec);
  EXPECT_TRUE(data->absent().empty());
  const Frame first = data->load(0), last = data->load(39);
  EXPECT_DOUBLE_EQ(*last.timestamp_s - *first.timestamp_s, 1.3);
  EXPECT_LT(norm(last.T_world_camera->origin - first.T_world_camera->origin), 1);
}

TEST(RealData, a_full_hd_frame_of_an_azure_kinect_reads_without_colour) {
  FACET_REQUIRE_DATA("azure_frame");
  const auto spec =
      spec_of("folder", "azure_frame",
              {{"depth", "{id}.png"}, {"depth_unit_m", "0.001"}, {"intrinsics_file", "intrinsics.K"}});
  const DatasetReport report = verify_dataset(spec);
  EXPECT_TRUE(report.is_whole());
  ASSERT_EQ(report.image_sizes.size(), 1u);
  EXPECT_EQ(report.image_sizes[0].size, (Size{1920, 1080}));
  EXPECT_NEAR(report.missing_share, 0.51, 0.01);
}

TEST(RealData, table_top_frames_read_with_registered_colour) {
  FACET_REQUIRE_DATA("tabletop");
  const auto spec = spec_of("folder", "tabletop",
                            {{"depth", "{id}.depth.png"},
                             {"color", "{id}.color.png"},
                             {"registered", "true"},
                             {"depth_unit_m", "0.001"},
                             {"intrinsics", "612.937,613.173,322.549,248.158"}});
  const DatasetReport report = verify_dataset(spec);
  EXPECT_TRUE(report.is_whole());
  EXPECT_EQ(report.with_color, 4u);
}

TEST(RealData, a_tum_sequence_reads_with_colours_and_poses) {
  FACET_REQUIRE_DATA("tum_fr1_rpy");
  const DatasetSpec spec = spec_of("tum", "tum_fr1_rpy", {{"intrinsics", "517.3,516.5,318.6,255.3"}});
  const DatasetReport report = verify_dataset(spec);
  EXPECT_TRUE(report.is_whole());
  EXPECT_EQ(report.frames, 40u);
  EXPECT_EQ(report.with_color, 40u);
  EXPECT_LT(report.farthest_m, 13);
  const auto data = open_dataset(spec);
  double before_s = 0;
  for (std::size_t i = 0; i < data->size(); ++i) {
    const Frame frame = data->load(i);
    EXPECT_GT(*frame.timestamp_s, before_s);
    EXPECT_TRUE(frame.T_world_camera) << frame.id;
    before_s = *frame.timestamp_s;
  }
}

}  // namespace
}  // namespace facet
