#include "dataset/azure_mkv.hpp"

#include <gtest/gtest.h>
#include <random>

#include "dataset/azure_recording.hpp"
#include "dataset/mkv_depth_track.hpp"
#include "dataset/mkv_writer.hpp"
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

namespace facet {
namespace {

constexpr Size binned{320, 288};

class AzureMkv : public ::testing::Test {
 protected:
  AzureMkv() {
    if (libavformat_version().empty()) return;
    spec_.name = "mine";
    spec_.reader = "azure_mkv";
    spec_.root = folder_.path() / "recording.mkv";
    writer_.calibration = calibration_text();
    for (int i = 0; i < 5; ++i) add_frame(33333u * static_cast<unsigned>(i), i);
  }
  void SetUp() override {
    if (libavformat_version().empty()) GTEST_SKIP() << "built without libavformat";
  }
  void add_frame(std::uint64_t time_us, int pattern) {
    writer_.frames.push_back({time_us, big_endian_bytes(depth_pattern(binned, pattern))});
    writer_.duration_us = static_cast<double>(time_us) + 33333;
  }
  std::unique_ptr<Dataset> open() {
    writer_.write(spec_.root);
    return open_dataset(spec_);
  }
  void expect_pattern(const Frame& frame, int pattern) const {
    const Image<std::uint16_t> expected = depth_pattern(binned, pattern);
    int wrong = 0;
    for (int y = 0; y < binned.height; ++y)
      for (int x = 0; x < binned.width; ++x)
        wrong += frame.depth_m(x, y) != static_cast<float>(expected(x, y) * 0.001) ||
                 frame.depth_m(x, y) != metres_of(frame.counted.counts(x, y), frame.counted.unit_m);
    EXPECT_EQ(wrong, 0) << frame.id;
  }

  TemporaryFolder folder_;
  DatasetSpec spec_;
  MkvWriter writer_;
};

TEST_F(AzureMkv, reads_back_exactly_what_was_recorded) {
  const auto data = open();
  EXPECT_TRUE(data->is_sequence());
  EXPECT_EQ(data->sensor(), Sensor::azure_kinect);
  ASSERT_EQ(data->size(), 5u);
  EXPECT_TRUE(data->absent().empty()) << data->absent()[0];
  for (std::size_t i = 0; i < 5; ++i) {
    const Frame frame = data->load(i);
    expect_pattern(frame, static_cast<int>(i));
    EXPECT_DOUBLE_EQ(*frame.timestamp_s, 0.033333 * static_cast<double>(i));
    // 0.4921875 x 512 and 0.5 x 512 - 96 - 0.5.
    EXPECT_EQ(frame.camera, (Camera{252, 253, 159.5f, 173.5f}));
  }
}

TEST_F(AzureMkv, reads_frames_in_any_order) {
  const auto data = open();
  for (const std::size_t i : {4u, 0u, 2u, 2u, 1u, 3u}) expect_pattern(data->load(i), static_cast<int>(i));
}

TEST_F(AzureMkv, reads_the_depth_track_among_others) {
  writer_.tracks.insert(writer_.tracks.begin(), {"COLOR", "MJPG", 1280, 720});
  for (MkvWriter::Frame& frame : writer_.frames) frame.track = 1;
  writer_.frames.insert(writer_.frames.begin() + 2, {66666, "not an image", 0});
  writer_.depth_mode.clear();  // the writer's tag is for the first track
  const auto data = open();
  ASSERT_EQ(data->size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) expect_pattern(data->load(i), static_cast<int>(i));
}

TEST_F(AzureMkv, takes_the_lens_out_by_the_nearest_pixel) {
  writer_.calibration = calibration_text(0.2);
  const auto data = open();
  const Frame frame = data->load(0);
  const Image<std::uint16_t> recorded = depth_pattern(binned, 0);
  // 100 px right of the centre: r = 100/252, seen at r (1 + 0.2 r^2) = 103.1 px.
  EXPECT_EQ(frame.depth_m(260, 173), static_cast<float>(recorded(263, 173) * 0.001));
  EXPECT_EQ(frame.depth_m(160, 173), static_cast<float>(recorded(160, 173) * 0.001));
  spec_.options["undistort"] = "false";
  expect_pattern(open()->load(0), 0);
  EXPECT_NE(open()->description().find("lens ignored"), std::string::npos);
}

TEST_F(AzureMkv, counts_duplicates_disorder_and_lost_frames) {
  add_frame(300000, 5);  // four after 133 ms are not there
  add_frame(166665, 6);
  add_frame(166665, 7);
  writer_.frames.push_back({333333, "half a frame"});
  const auto data = open();
  EXPECT_EQ(data->size(), 7u);
  EXPECT_EQ(data->absent(),
            (std::vector<std::string>{"1 entry of the depth track left out: cut off, or of another size",
                                      "1 entry of the depth track left out: another one has the time",
                                      "2 entries of the depth track out of order, put in order",
                                      "3 entries absent, by the times of the others"}));
  expect_pattern(data->load(6), 5);
  expect_pattern(data->load(5), 6);
}

TEST_F(AzureMkv, a_file_that_is_cut_off_gives_what_is_there) {
  for (int i = 5; i < 20; ++i) add_frame(33333u * static_cast<unsigned>(i), i);
  writer_.write(spec_.root);
  const auto size = std::filesystem::file_size(spec_.root);
  std::filesystem::resize_file(spec_.root, size / 2);
  const auto data = open_dataset(spec_);
  ASSERT_GE(data->size(), 8u);
  ASSERT_LE(data->size(), 10u);
  for (std::size_t i = 0; i < data->size(); ++i) expect_pattern(data->load(i), static_cast<int>(i));
  ASSERT_FALSE(data->absent().empty());
  EXPECT_NE(data->absent().back().find("the file is cut off: the last 0.4"), std::string::npos)
      << data->absent().back();
}

TEST_F(AzureMkv, says_what_is_wrong_with_a_file) {
  const auto refuses = [&](const std::string& part) {
    writer_.write(spec_.root);
    expect_error(ErrorKind::data, part, [&] { open_dataset(spec_); });
  };
  expect_error(ErrorKind::data, "recording.mkv: file is missing", [&] { open_dataset(spec_); });
  writer_.calibration.clear();
  refuses("calibration.json is not attached; give the option intrinsics");
  writer_.calibration = "{";
  refuses("calibration.json: no calibration of an Azure Kinect");
  writer_.calibration = calibration_text();
  writer_.depth_mode = "WFOV_UNBINNED";
  refuses("the depth mode WFOV_UNBINNED has images of another size");
  writer_.tracks[0].fourcc = "MJPG";
  refuses("not of 16-bit big-endian images");
  writer_.tracks[0].name = "COLOR";
  refuses("no track is called DEPTH");
  writer_.tracks[0] = {};
  writer_.frames = {{0, "short"}};
  refuses("no whole depth frame is in it");
  writer_.frames.clear();
  refuses("no readable Matroska file");
}

TEST_F(AzureMkv, needs_no_calibration_where_intrinsics_are_given) {
  writer_.calibration.clear();
  spec_.options = {{"intrinsics", "250,251,160,144"}};
  const Frame frame = open()->load(1);
  EXPECT_EQ(frame.camera, (Camera{250, 251, 160, 144}));
  expect_pattern(frame, 1);
}

TEST(AzureMkvWithoutLibavformat, says_how_to_build_with_it) {
  if (!libavformat_version().empty()) GTEST_SKIP() << "built with libavformat";
  DatasetSpec spec;
  spec.reader = "azure_mkv";
  spec.root = "recording.mkv";
  expect_error(ErrorKind::not_measured, "build with FACET_LIBAV=ON", [&] { open_dataset(spec); });
}

TEST_F(AzureMkv, damaged_files_are_refused_or_read_in_part) {
  std::mt19937 random(3);
  writer_.frames.resize(2);
  const std::string whole = writer_.text();
  for (int round = 0; round < 300; ++round) {
    std::string damaged = whole;
    for (unsigned i = 0; i <= random() % 20; ++i)
      damaged[random() % (round % 2 == 0 ? 1500 : damaged.size())] = static_cast<char>(random() % 256);
    std::ofstream(spec_.root, std::ios::binary) << damaged;
    try {
      const auto data = open_dataset(spec_);
      for (std::size_t i = 0; i < data->size(); ++i) EXPECT_EQ(data->load(i).depth_m.size(), binned);
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::data) << e.what();
    }
  }
}

}  // namespace
}  // namespace facet
