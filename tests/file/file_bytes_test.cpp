#include "file/file_bytes.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <string>

#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

namespace facet {
namespace {

TEST(FileBytes, valid_utf8_stays_and_other_bytes_are_escaped) {
  EXPECT_EQ(escaped_utf8("plain"), "plain");
  EXPECT_EQ(escaped_utf8("\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80"), "\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80");
  EXPECT_EQ(escaped_utf8("a\xFF"
                         "b"),
            "a%FFb");
  EXPECT_EQ(escaped_utf8("\xC3"), "%C3");                       // broken off
  EXPECT_EQ(escaped_utf8("\xC0\x80"), "%C0%80");                // overlong
  EXPECT_EQ(escaped_utf8("\xE0\x80\x80"), "%E0%80%80");         // overlong
  EXPECT_EQ(escaped_utf8("\xED\xA0\x80"), "%ED%A0%80");         // surrogate
  EXPECT_EQ(escaped_utf8("\xF4\x90\x80\x80"), "%F4%90%80%80");  // beyond U+10FFFF
}

TEST(FileBytes, a_written_file_is_read_back_and_leaves_no_other_file) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "deep" / "er" / "file";
  write_file_atomically(path, std::string_view("old and longer"));
  write_file_atomically(path, std::string_view("new\0!", 5));
  const auto bytes = read_file_bytes(path);
  EXPECT_EQ(std::string(bytes.begin(), bytes.end()), std::string("new\0!", 5));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(path.parent_path()), {}), 1);
}

TEST(FileBytes, what_cannot_be_read_is_named_with_its_rule) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "f\xFF";
  expect_error(ErrorKind::data, "f%FF: file is missing", [&] { read_file_bytes(path); });
  std::ofstream(path).close();
  expect_error(ErrorKind::data, "f%FF: file is empty", [&] { read_file_bytes(path); });
  expect_error(ErrorKind::data, "is not a file", [&] { read_file_bytes(folder.path()); });
}

TEST(FileBytes, what_cannot_be_written_is_an_internal_error_and_leaves_no_other_file) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "target" / "inside");  // a file cannot replace it
  expect_error(ErrorKind::internal, "cannot be written",
               [&] { write_file_atomically(folder.path() / "target", std::string_view("x")); });
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

}  // namespace
}  // namespace facet
