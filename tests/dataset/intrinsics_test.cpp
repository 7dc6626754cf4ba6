#include "dataset/intrinsics.hpp"

#include <gtest/gtest.h>

#include "file/file_bytes.hpp"
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

namespace facet {
namespace {

TEST(Intrinsics, are_read_from_the_nine_numbers_of_k) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "K.txt";
  write_file_atomically(path, std::string_view(" 5.85e+02\t 0.0e+00\t 3.2e+02\t\r\n0 584.5 240\n0 0 1"));
  EXPECT_EQ(read_intrinsics_file(path), (Camera{585.0f, 584.5f, 320.0f, 240.0f}));
}

TEST(Intrinsics, in_a_file_of_anything_else_are_an_error) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "K.txt";
  for (const char* text : {"1 0 2 0 3 4 0 0", "1 0 2 0 3 4 0 0 1 5", "1 0 2 0 3 4 0 0 2", "1 9 2 0 3 4 0 0 1",
                           "1 0 x 0 3 4 0 0 1", "fx: 1"}) {
    write_file_atomically(path, std::string_view(text));
    expect_error(ErrorKind::data, "K.txt: expected the nine numbers of K",
                 [&] { read_intrinsics_file(path); });
  }
  expect_error(ErrorKind::data, "L.txt: file is missing",
               [&] { read_intrinsics_file(folder.path() / "L.txt"); });
}

TEST(Intrinsics, come_from_one_option_or_the_other) {
  const TemporaryFolder folder;
  write_file_atomically(folder.path() / "K", std::string_view("1 0 2 0 3 4 0 0 1"));
  EXPECT_EQ(intrinsics_option({}, folder.path()), std::nullopt);
  EXPECT_EQ(intrinsics_option({{"intrinsics", "1,2,3,4.5"}}, folder.path()), (Camera{1, 2, 3, 4.5f}));
  EXPECT_EQ(intrinsics_option({{"intrinsics_file", "K"}}, folder.path()), (Camera{1, 3, 2, 4}));
  expect_error(ErrorKind::config, "exclude each other", [&] {
    intrinsics_option({{"intrinsics", "1,2,3,4"}, {"intrinsics_file", "K"}}, folder.path());
  });
  expect_error(ErrorKind::config, "expected [fx, fy, cx, cy]", [&] {
    intrinsics_option({{"intrinsics", "1,2,3"}}, folder.path());
  });
}

}  // namespace
}  // namespace facet
