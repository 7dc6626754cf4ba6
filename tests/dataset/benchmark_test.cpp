#include "dataset/benchmark.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <thread>

#include "file/file_bytes.hpp"
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"
#include "synth_io/write_benchmark.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;

const std::string two_sets =
    "schema: 1\nname: two\nsets:\n  - {name: a, scenes: boxes}\n  - {name: b, scenes: mixed}\n";
const std::string sequences = "schema: 1\nname: s\nsets: [{name: s, scenes: boxes, count: 2, frames: 2}]\n";
const std::string two_sensors =
    "schema: 1\nname: t\nsets:\n  - {name: a, scenes: boxes}\n"
    "  - {name: b, scenes: boxes, sensor: {model: azure_kinect}}\n";

class BenchmarkReader : public ::testing::Test {
 protected:
  DatasetSpec spec_of(const std::string& text) const {
    write_file_atomically(folder.path() / "spec.yaml.txt", text);
    DatasetSpec spec;
    spec.name = "mine";
    spec.reader = "benchmark";
    spec.root = folder.path() / "spec.yaml.txt";
    spec.options = {{"cache", "cache"}};
    return spec;
  }
  std::size_t files_in_cache() const {
    std::size_t count = 0;
    if (!fs::exists(folder.path() / "cache")) return 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder.path() / "cache"))
      count += entry.is_regular_file();
    return count;
  }
  TemporaryFolder folder;
};

void expect_same(const Frame& a, const Frame& b) {
  ASSERT_EQ(a.depth_m.size(), b.depth_m.size());
  for (int y = 0; y < a.depth_m.height(); ++y)
    ASSERT_TRUE(std::equal(a.depth_m.row(y), a.depth_m.row(y) + a.depth_m.width(), b.depth_m.row(y)));
  EXPECT_EQ(a.camera.fx, b.camera.fx);
  EXPECT_EQ(a.camera.fy, b.camera.fy);
  EXPECT_EQ(a.camera.cx, b.camera.cx);
  EXPECT_EQ(a.camera.cy, b.camera.cy);
}

TEST_F(BenchmarkReader, renders_a_frame_when_it_is_first_read_and_reads_it_from_the_cache_afterwards) {
  const DatasetSpec spec = spec_of(two_sets);
  const auto data = open_dataset(spec);
  ASSERT_EQ(data->size(), 2u);
  EXPECT_EQ(data->frame_id(1), "b.mixed_000");
  EXPECT_EQ(files_in_cache(), 0u);
  const Frame first = data->load(0);
  EXPECT_EQ(files_in_cache(), 6u);  // depth, colour, masks, annotation, geometry; the spec
  const auto written = fs::last_write_time(first.files.front());
  const auto bytes = read_file_bytes(first.files.front());
  const Frame again = open_dataset(spec)->load(0);
  EXPECT_EQ(again.files, first.files);
  EXPECT_EQ(fs::last_write_time(again.files.front()), written);
  expect_same(first, again);
  fs::remove(first.files.front());  // what is lost is made again, byte for byte
  expect_same(first, data->load(0));
  EXPECT_EQ(read_file_bytes(first.files.front()), bytes);
}

TEST_F(BenchmarkReader, gives_the_frames_that_a_written_folder_has_to_either_reader) {
  DatasetSpec spec = spec_of(two_sensors);
  const fs::path out = folder.path() / "out";
  write_benchmark(read_benchmark_spec(spec.root), out, 1);
  for (const std::string set : {"a", "b"}) {
    spec.options = {{"cache", "cache"}, {"set", set}};
    DatasetSpec written = spec, plain;
    written.root = out;
    plain.name = set;
    plain.reader = "folder";
    plain.root = out / set;
    const auto rendered = open_dataset(spec);
    const Frame frame = rendered->load(0);
    expect_same(frame, open_dataset(written)->load(0));
    expect_same(frame, open_dataset(plain)->load(0));
    EXPECT_EQ(rendered->sensor(), open_dataset(plain)->sensor());
    EXPECT_TRUE(frame.object_masks.has_value());
  }
}

TEST_F(BenchmarkReader, threads_that_render_the_same_frame_read_the_same) {
  const auto data = open_dataset(spec_of(two_sets));
  Frame one, two;
  {
    const std::jthread thread([&] { one = data->load(0); });
    two = data->load(0);
  }
  expect_same(one, two);
}

TEST_F(BenchmarkReader, another_seed_has_frames_and_a_place_of_its_own) {
  DatasetSpec spec = spec_of(two_sets);
  const Frame first = open_dataset(spec)->load(0);
  spec.options["seed"] = "2";
  const Frame second = open_dataset(spec)->load(0);
  EXPECT_NE(first.files, second.files);
  EXPECT_NE(read_file_bytes(first.files.front()), read_file_bytes(second.files.front()));
}

TEST_F(BenchmarkReader, sequences_and_mixed_sensors_must_be_chosen_and_the_choices_are_named) {
  DatasetSpec spec = spec_of(sequences);
  expect_error(ErrorKind::config, "name one of s/boxes_000, s/boxes_001", [&] { open_dataset(spec); });
  spec.options["set"] = "s/boxes_001";
  const auto data = open_dataset(spec);
  EXPECT_TRUE(data->is_sequence());
  EXPECT_EQ(data->size(), 2u);
  spec.options["set"] = "other";
  expect_error(ErrorKind::config, "there is no 'other'", [&] { open_dataset(spec); });
  expect_error(ErrorKind::config, "different sensors, name one of a, b",
               [&] { open_dataset(spec_of(two_sensors)); });
}

TEST_F(BenchmarkReader, says_which_frames_are_absent_and_which_lack_objects_once_they_are_there) {
  const std::string text =
      "schema: 1\nname: s\nsets:\n  - {name: full, scenes: clutter, vary: {objects: [1, 60]}}\n"
      "  - {name: far, scenes: boxes, vary: {distance_m: [0.3, 1]}}\n";
  DatasetSpec spec = spec_of(text);
  const auto data = open_dataset(spec);
  ASSERT_EQ(data->size(), 3u);
  EXPECT_EQ(data->absent(), std::vector<std::string>{"far.distance_m_0.3_000: n/a (range)"});
  EXPECT_EQ(data->shortfall(1), "");  // not rendered yet
  for (const std::size_t k : {0, 1, 2}) data->load(k);
  EXPECT_EQ(data->shortfall(0), "");
  EXPECT_NE(data->shortfall(1).find(" of 60 objects found room"), std::string::npos) << data->shortfall(1);
  spec.options["set"] = "far";
  EXPECT_EQ(open_dataset(spec)->absent(), std::vector<std::string>{"distance_m_0.3_000: n/a (range)"});
}

TEST_F(BenchmarkReader, refuses_a_folder_that_is_not_finished) {
  const DatasetSpec spec = spec_of(two_sets);
  DatasetSpec written = spec;
  written.root = folder.path() / "out";
  written.options.clear();
  write_benchmark(read_benchmark_spec(spec.root), written.root, 1);
  EXPECT_EQ(open_dataset(written)->size(), 2u);
  write_file_atomically(written.root / "unfinished.txt", "x");
  expect_error(ErrorKind::data, "is unfinished", [&] { open_dataset(written); });
}

TEST_F(BenchmarkReader, says_what_is_wrong_with_root_spec_and_options) {
  DatasetSpec spec = spec_of("schema: 1\nname: x\nsets: [{name: a, scenes: pyramids}]\n");
  expect_error(ErrorKind::config, "spec.yaml.txt:3:26: sets[0].scenes", [&] { open_dataset(spec); });
  spec.root = folder.path() / "nothing";
  expect_error(ErrorKind::data, "nothing: neither the spec", [&] { open_dataset(spec); });
  spec = spec_of(two_sets);
  spec.options["seed"] = "1.5";
  expect_error(ErrorKind::config, "option seed: expected a whole number", [&] { open_dataset(spec); });
  spec = spec_of(two_sets);
  spec.options["cache"] = "spec.yaml.txt";  // a file
  const auto data = open_dataset(spec);
  expect_error(ErrorKind::internal, "spec.yaml.txt/synth", [&] { data->load(0); });
}

TEST_F(BenchmarkReader, takes_fewer_scenes_of_every_level_and_says_what_each_frame_varies) {
  DatasetSpec spec =
      spec_of("schema: 1\nname: n\nsets: [{name: n, scenes: boxes, count: 3, vary: {noise: [0, 0.5]}}]\n");
  EXPECT_EQ(open_dataset(spec)->size(), 6u);
  spec.options["count"] = "1";
  const auto data = open_dataset(spec);
  ASSERT_EQ(data->size(), 2u);
  ASSERT_TRUE(data->level(1));
  EXPECT_EQ(data->level(1)->axis, "noise");
  EXPECT_EQ(data->level(1)->value, 0.5);
  EXPECT_FALSE(open_dataset(spec_of(two_sets))->level(0));
}

}  // namespace
}  // namespace facet
