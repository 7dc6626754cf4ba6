#include "dataset/folder_layout.hpp"

#include <gtest/gtest.h>

#include "file/file_bytes.hpp"
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

namespace facet {
namespace {

TEST(FolderLayout, a_folder_without_dataset_yaml_has_no_options) {
  const TemporaryFolder folder;
  EXPECT_TRUE(read_dataset_yaml(folder.path()).empty());
}

TEST(FolderLayout, lists_are_joined_by_commas) {
  const TemporaryFolder folder;
  write_file_atomically(folder.path() / "dataset.yaml",
                        std::string_view("missing_codes: [65535, 1]\nsequence: true\n"));
  const ReaderOptions options = read_dataset_yaml(folder.path());
  EXPECT_EQ(options, (ReaderOptions{{"missing_codes", "65535,1"}, {"sequence", "true"}}));
}

TEST(FolderLayout, errors_of_dataset_yaml_name_line_and_column) {
  const TemporaryFolder folder;
  const std::vector<std::pair<std::string, std::string>> cases{
      {"depth: a\n  b: [", "dataset.yaml:2:"},
      {"- depth", "dataset.yaml:1:1: expected a map"},
      {"registered: true\ndeptth: x",
       "dataset.yaml:2:1: data set folder: unknown option 'deptth'; known: depth, color"},
      {"registered: true\nregistered: false", "dataset.yaml:2:1: 'registered' stands twice"},
      {"depth: {id}.png", "dataset.yaml:1:"},  // a flow map without quotes
      {"missing_codes: [[1]]", "dataset.yaml:1:17: missing_codes: expected a list of values"},
      {"registered: maybe", "dataset.yaml:1:1: data set folder: option registered: expected true or false"},
      {"<<: {depth: a}", "dataset.yaml:1:"},
  };
  for (const auto& [text, part] : cases) {
    write_file_atomically(folder.path() / "dataset.yaml", text);
    expect_error(ErrorKind::config, part, [&] { read_dataset_yaml(folder.path()); });
  }
}

TEST(FolderLayout, required_options_are_asked_for) {
  ReaderOptions options;
  const auto expect_missing = [&](const std::string& part) {
    expect_error(ErrorKind::config, part, [&] { folder_layout(options, "root"); });
  };
  expect_missing("root: option depth is required");
  options["depth"] = "{id}.png";
  expect_missing("root: option depth_unit_m is required");
  options["depth_unit_m"] = "-0.001";
  expect_missing("expected a positive number of metres");
  options["depth_unit_m"] = "0.001";
  expect_missing("option intrinsics or intrinsics_file is required");
  options["intrinsics"] = "1,1,0,0";
  options["sensor"] = "kinect_v3";
  expect_missing("option sensor: 'kinect_v3' is not known");
}

}  // namespace
}  // namespace facet
