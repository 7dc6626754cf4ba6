#include "dataset/reader_options.hpp"

#include <array>
#include <gtest/gtest.h>

#include "support/expect_error.hpp"

namespace facet {
namespace {

constexpr std::array<OptionInfo, 4> known{{{"text", OptionType::text, ""},
                                           {"number", OptionType::number, ""},
                                           {"flag", OptionType::flag, ""},
                                           {"numbers", OptionType::numbers, ""}}};

TEST(ReaderOptions, are_read_as_their_types) {
  const ReaderOptions options{
      {"text", "a b"}, {"number", "1e-3"}, {"flag", "false"}, {"numbers", "1, -2.5,3"}};
  check_options(options, known, "here");
  EXPECT_EQ(text_option(options, "text"), "a b");
  EXPECT_EQ(number_option(options, "number"), 0.001);
  EXPECT_EQ(flag_option(options, "flag"), false);
  EXPECT_EQ(numbers_option(options, "numbers"), (std::vector<double>{1, -2.5, 3}));
  EXPECT_EQ(numbers_option({{"numbers", ""}}, "numbers"), std::vector<double>{});
}

TEST(ReaderOptions, that_are_absent_are_nothing) {
  EXPECT_FALSE(text_option({}, "text") || number_option({}, "number") || numbers_option({}, "numbers"));
  EXPECT_FALSE(flag_option({}, "flag").has_value());
}

TEST(ReaderOptions, that_are_unknown_are_named_with_the_known_ones) {
  expect_error(ErrorKind::config, "here: unknown option 'txt'; known: text, number, flag, numbers", [] {
    check_options({{"txt", "1"}}, known, "here");
  });
}

TEST(ReaderOptions, of_another_type_are_named) {
  const std::vector<std::pair<ReaderOptions, std::string>> cases{
      {{{"number", "1x"}}, "here: option number: expected a number, got '1x'"},
      {{{"number", ""}}, "expected a number"},
      {{{"number", "nan"}}, "expected a number"},
      {{{"number", "1e999"}}, "expected a number"},
      {{{"flag", "yes"}}, "option flag: expected true or false, got 'yes'"},
      {{{"numbers", "1,,2"}}, "option numbers: expected a list of numbers"},
      {{{"numbers", "1,"}}, "expected a list of numbers"},
  };
  for (const auto& [options, message] : cases)
    expect_error(ErrorKind::config, message, [&] { check_options(options, known, "here"); });
}

}  // namespace
}  // namespace facet
