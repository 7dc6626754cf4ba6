#include "dataset/registry.hpp"

#include <gtest/gtest.h>
#include <set>

#include "support/expect_error.hpp"

namespace facet {
namespace {

TEST(Registry, every_reader_is_documented_and_has_a_name_of_its_own) {
  std::set<std::string_view> names;
  for (const ReaderInfo& reader : readers()) {
    EXPECT_TRUE(names.insert(reader.name).second) << reader.name;
    EXPECT_FALSE(reader.doc.empty());
    EXPECT_EQ(&find_reader(reader.name), &reader);
    for (const OptionInfo& option : reader.options) EXPECT_FALSE(option.doc.empty()) << option.name;
  }
}

TEST(Registry, an_unknown_reader_is_named_with_the_known_ones) {
  DatasetSpec spec;
  spec.reader = "ods";
  expect_error(ErrorKind::config, "no reader is called 'ods'; there are: osd, folder",
               [&] { open_dataset(spec); });
}

TEST(Registry, an_option_of_another_reader_is_refused) {
  DatasetSpec spec;
  spec.name = "mine";
  spec.reader = "osd";
  spec.options = {{"depth_unit_m", "1"}};
  expect_error(ErrorKind::config, "data set 'mine': unknown option 'depth_unit_m'",
               [&] { open_dataset(spec); });
}

}  // namespace
}  // namespace facet
