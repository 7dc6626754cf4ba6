#include "synth_io/write_benchmark.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <sstream>

#include "core/error.hpp"
#include "file/file_bytes.hpp"
#include "file/image_file.hpp"
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"
#include "synth_io/validate_benchmark.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;

const char* const small_spec = R"(schema: 1
name: small
seed: 3
sets:
  - {name: boxes, scenes: boxes, count: 2}
  - {name: far, scenes: mixed, sensor: {model: azure_kinect}, vary: {distance_m: [0.3, 1.2]}}
  - {name: moving, scenes: cylindrical, frames: 3, path: {yaw_deg: 20}}
)";

std::vector<std::string> files_of(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) names.push_back(fs::relative(entry.path(), folder).generic_string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

TEST(WriteBenchmark, GivesTheSameBytesOnOneAndTwoThreadsAndPassesItsValidation) {
  const TemporaryFolder folder;
  const BenchmarkSpec spec = parse_benchmark_spec(small_spec, "small.yaml");
  std::size_t last = 0;
  const BenchmarkSummary one =
      write_benchmark(spec, folder.path() / "one", 1, [&](std::size_t done) { last = done; });
  write_benchmark(spec, folder.path() / "two", 2);
  EXPECT_EQ(one.frames, 6u);
  EXPECT_EQ(last, 6u);
  EXPECT_EQ(one.not_available, std::vector<std::string>{"far/distance_m_0.3_000: n/a (range)"});
  EXPECT_EQ(one.folders.size(), 3u);
  const auto names = files_of(folder.path() / "one");
  ASSERT_EQ(names, files_of(folder.path() / "two"));
  for (const std::string& name : names) {
    EXPECT_EQ(read_file_bytes(folder.path() / "one" / name), read_file_bytes(folder.path() / "two" / name))
        << name;
  }
  const ValidationReport report = validate_benchmark(folder.path() / "one");
  EXPECT_EQ(report.frames, 6u);
  EXPECT_TRUE(report.problems.empty()) << report.problems[0];
  EXPECT_TRUE(fs::exists(folder.path() / "one/moving/cylindrical_000/poses.txt"));
  EXPECT_EQ(one.shortfalls.size(), 0u);
}

TEST(WriteBenchmark, FramesOfASequenceDifferInNoiseAndShowTheSameScene) {
  const TemporaryFolder folder;
  const auto spec =
      parse_benchmark_spec("schema: 1\nname: s\nsets: [{name: s, scenes: boxes, frames: 2}]\n", "s.yaml");
  write_benchmark(spec, folder.path() / "s", 1);
  const fs::path root = folder.path() / "s/s/boxes_000";
  EXPECT_EQ(read_file_bytes(root / "color/frame_000.png"), read_file_bytes(root / "color/frame_001.png"));
  const cv::Mat a = read_image_file(root / "depth/frame_000.png").pixels,
                b = read_image_file(root / "depth/frame_001.png").pixels;
  int differ = 0, appear = 0;
  for (int y = 0; y < a.rows; ++y) {
    for (int x = 0; x < a.cols; ++x) {
      const int u = a.at<std::uint16_t>(y, x), v = b.at<std::uint16_t>(y, x);
      differ += u != v;
      appear += (u == 0) != (v == 0);
    }
  }
  EXPECT_GT(differ, 100000);  // independent noise
  EXPECT_GT(appear, 100);     // borders of missing regions move
  EXPECT_LT(appear, 20000);
}

TEST(WriteBenchmark, PosesOfAMovingCameraLookAtTheSceneFromTheirPlaces) {
  const TemporaryFolder folder;
  const auto spec = parse_benchmark_spec(
      "schema: 1\nname: s\nsets: [{name: s, scenes: boxes, frames: 3, path: {yaw_deg: 90}}]\n", "s.yaml");
  write_benchmark(spec, folder.path() / "s", 1);
  const auto bytes = read_file_bytes(folder.path() / "s/s/boxes_000/poses.txt");
  std::istringstream lines(std::string(bytes.begin(), bytes.end()));
  std::string line;
  std::getline(lines, line);
  double t, x, y, z, qx, qy, qz, qw, first_x = 0, first_y = 0;
  int count = 0;
  for (; lines >> t >> x >> y >> z >> qx >> qy >> qz >> qw; ++count) {
    EXPECT_NEAR(t, count / 30.0, 1e-6);
    EXPECT_NEAR(qx * qx + qy * qy + qz * qz + qw * qw, 1, 1e-6);
    const double distance = std::hypot(x, y, z - 0.07);         // the scenes' middle is 7 cm above the table
    EXPECT_NEAR(2 * (qx * qz + qy * qw), -x / distance, 1e-6);  // optical axis in the world
    EXPECT_NEAR(2 * (qy * qz - qx * qw), -y / distance, 1e-6);
    EXPECT_NEAR(1 - 2 * (qx * qx + qy * qy), -(z - 0.07) / distance, 1e-6);
    if (count == 0) first_x = x, first_y = y;
  }
  ASSERT_EQ(count, 3);
  EXPECT_NEAR(x, -first_y, 1e-6);  // a quarter turn
  EXPECT_NEAR(y, first_x, 1e-6);
}

TEST(WriteBenchmark, ValidationNamesAChangedFileAndABrokenAnnotation) {
  const TemporaryFolder folder;
  const auto spec = parse_benchmark_spec("schema: 1\nname: s\nsets: [{name: s, scenes: boxes}]\n", "s.yaml");
  write_benchmark(spec, folder.path() / "s", 1);
  const fs::path file = folder.path() / "s/s/truth/boxes_000.json";
  const auto bytes = read_file_bytes(file);
  std::string text(bytes.begin(), bytes.end());
  text.replace(text.find("\"edge/1\""), 8, "\"edge/2\"");
  write_file_atomically(file, text);
  const ValidationReport report = validate_benchmark(folder.path() / "s");
  ASSERT_EQ(report.problems.size(), 2u);
  EXPECT_NE(report.problems[0].find("repeated label edge/2"), std::string::npos) << report.problems[0];
  EXPECT_NE(report.problems[1].find("the checksum differs"), std::string::npos);
}

TEST(WriteBenchmark, AnInterruptedFolderIsNeverTakenForAWholeOneAndTheSameCallCompletesIt) {
  const TemporaryFolder folder;
  const BenchmarkSpec spec = parse_benchmark_spec(small_spec, "small.yaml");
  const fs::path whole = folder.path() / "whole", broken = folder.path() / "broken";
  write_benchmark(spec, whole, 1);
  const auto stop = [](std::size_t done) {
    if (done == 3) throw Error(ErrorKind::internal, "stopped");
  };
  EXPECT_THROW(write_benchmark(spec, broken, 1, stop), Error);
  write_file_atomically(broken / "boxes/depth/boxes_001.png.tmp-1-2", "half a picture");
  EXPECT_FALSE(fs::exists(broken / "spec.yaml"));
  EXPECT_FALSE(fs::exists(broken / "boxes/dataset.yaml"));
  expect_error(ErrorKind::data, "is unfinished", [&] { validate_benchmark(broken); });
  expect_error(ErrorKind::data, "is unfinished", [&] { validate_annotations(broken / "boxes/truth"); });
  BenchmarkSpec other = parse_benchmark_spec(small_spec, "small.yaml");
  other.text += "# changed\n";
  expect_error(ErrorKind::usage, "unfinished benchmark of another spec",
               [&] { write_benchmark(other, broken, 1); });
  const auto kept = fs::last_write_time(broken / "boxes/depth/boxes_000.png");
  EXPECT_EQ(write_benchmark(spec, broken, 2).frames, 6u);
  EXPECT_EQ(fs::last_write_time(broken / "boxes/depth/boxes_000.png"), kept);
  ASSERT_EQ(files_of(broken), files_of(whole));
  for (const std::string& name : files_of(whole))
    EXPECT_EQ(read_file_bytes(broken / name), read_file_bytes(whole / name)) << name;
  EXPECT_TRUE(validate_benchmark(broken).problems.empty());
}

TEST(WriteBenchmark, AFolderThatHoldsSomethingIsRefused) {
  const TemporaryFolder folder;
  write_file_atomically(folder.path() / "precious.txt", "x");
  EXPECT_THROW(write_benchmark(parse_benchmark_spec(small_spec, "small.yaml"), folder.path(), 1), Error);
  EXPECT_THROW(validate_annotations(folder.path()), Error);
}

}  // namespace
}  // namespace facet
