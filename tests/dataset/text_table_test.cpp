#include "dataset/text_table.hpp"

#include <gtest/gtest.h>

#include "support/expect_error.hpp"

namespace facet {
namespace {

TEST(TextTable, cuts_lines_at_blanks_and_skips_comments) {
  const auto lines = text_lines("# times\n1.5 a.png\r\n\n  2.5\tb.png  \n#3 c\n4 d");
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0], (TextLine{"1.5", "a.png"}));
  EXPECT_EQ(lines[1], (TextLine{"2.5", "b.png"}));
  EXPECT_EQ(lines[2], (TextLine{"4", "d"}));
}

TEST(TextTable, takes_finite_numbers_alone) {
  EXPECT_EQ(finite_number("7.0352107e-001"), 0.70352107);
  EXPECT_EQ(finite_number("+3"), 3);
  for (const char* text : {"", "-1.#IND", "nan", "inf", "1e999", "3x", " 3"})
    EXPECT_FALSE(finite_number(text)) << text;
}

TEST(TextTable, names_a_file_that_is_missing) {
  expect_error(ErrorKind::data, "nowhere.txt", [] { read_text_lines("nowhere.txt"); });
}

}  // namespace
}  // namespace facet
