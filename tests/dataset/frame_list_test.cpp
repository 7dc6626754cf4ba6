#include "dataset/frame_list.hpp"

#include <algorithm>
#include <gtest/gtest.h>

#include "file/file_bytes.hpp"
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

namespace facet {
namespace {

using Names = std::vector<std::string>;

TEST(FrameList, digits_are_ordered_as_numbers) {
  Names names{"test10", "learn44", "test2", "learn0", "learn9", "learn10", "a", "learn010", "", "10", "9"};
  std::sort(names.begin(), names.end(), natural_less);
  EXPECT_EQ(names, (Names{"", "9", "10", "a", "learn0", "learn9", "learn010", "learn10", "learn44", "test2",
                          "test10"}));
}

TEST(FrameList, natural_order_is_a_strict_weak_order) {
  const Names names{"",     "0",    "00", "1", "01", "1a", "a1", "a01", "a", "99999999999999999999999",
                    "a1b2", "a1b10"};
  for (const auto& a : names) {
    EXPECT_FALSE(natural_less(a, a));
    for (const auto& b : names) {
      if (a == b) continue;
      EXPECT_NE(natural_less(a, b), natural_less(b, a)) << a << " " << b;
      for (const auto& c : names)
        if (natural_less(a, b) && natural_less(b, c)) {
          EXPECT_TRUE(natural_less(a, c)) << a << " " << b << " " << c;
        }
    }
  }
}

TEST(FrameList, a_pattern_lists_what_fits_and_nothing_else) {
  const TemporaryFolder folder;
  for (const char* name :
       {"d/f10.z.png", "d/f9.z.png", "d/f9.rgb.png", "d/f.z.png", "d/g1.z.png", "f1.z.png"})
    write_file_atomically(folder.path() / name, std::string_view("x"));
  const FramePattern pattern("d/f{id}.z.png");
  EXPECT_EQ(pattern.list(folder.path()), (Names{"9", "10"}));
  EXPECT_EQ(pattern.path("root", "9"), "root/d/f9.z.png");
}

TEST(FrameList, a_pattern_needs_one_id_in_the_file_name) {
  for (const char* pattern : {"depth.png", "{id}/depth.png", "{id}_{id}.png", ""})
    expect_error(ErrorKind::config, "expected {id} once", [&] { FramePattern{pattern}; });
}

TEST(FrameList, a_missing_folder_is_named) {
  const TemporaryFolder folder;
  expect_error(ErrorKind::data, "nowhere: folder is missing",
               [&] { FramePattern("nowhere/{id}.png").list(folder.path()); });
}

TEST(FrameList, a_file_name_that_is_not_utf8_is_named_escaped) {
  const TemporaryFolder folder;
  write_file_atomically(folder.path() / "a\xE9.png", std::string_view("x"));
  expect_error(ErrorKind::data, "a%E9.png: file name is not UTF-8",
               [&] { FramePattern("{id}.png").list(folder.path()); });
}

TEST(FrameList, selection_keeps_its_own_order_and_names_every_absent_frame) {
  DatasetSpec spec;
  spec.name = "set";
  spec.root = "root";
  const Names available{"a", "b", "c"};
  EXPECT_EQ(select_frames(spec, available), available);
  spec.frames = {"c", "a"};
  EXPECT_EQ(select_frames(spec, available), (Names{"c", "a"}));
  spec.frames = {"x", "a", "y"};
  expect_error(ErrorKind::data, "root: data set 'set' has no frame x, y",
               [&] { select_frames(spec, available); });
  expect_error(ErrorKind::data, "no frame of data set 'set' is here", [&] { select_frames(spec, {}); });
}

}  // namespace
}  // namespace facet
