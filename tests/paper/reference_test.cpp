#include "paper/reference.hpp"

#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

namespace facet {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

ReferenceTables tables(const std::string& value) {
  return {{"table2", {ReportTable{"Table 2", {"scene", "found"}, {{"1", value}}, {}, ""}}}};
}

TEST(Reference, ReadsBackAndEqualTablesDoNotDiffer) {
  TemporaryFolder folder;
  std::ofstream(folder.path() / "r.json") << to_json(tables("3"));
  EXPECT_THAT(differences_from(read_reference(folder.path() / "r.json"), tables("3")), IsEmpty());
}

TEST(Reference, ADifferentCellIsNamedWithBothValues) {
  EXPECT_THAT(differences_from(tables("3"), tables("4")),
              ElementsAre("table2: Table 2: 1, found: 4 where the reference has 3"));
}

TEST(Reference, ATargetThatItLacksAndOtherRowsAreDifferences) {
  EXPECT_THAT(differences_from({}, tables("4")), ElementsAre(HasSubstr("table2")));
  ReferenceTables longer = tables("4");
  longer["table2"][0].rows.push_back({"2", "5"});
  EXPECT_THAT(differences_from(longer, tables("4")), ElementsAre(HasSubstr("other rows or columns")));
}

TEST(Reference, WithoutAFileNothingIsMeasuredAndADamagedOneIsAnError) {
  TemporaryFolder folder;
  expect_error(ErrorKind::not_measured, "no reference", [&] { read_reference(folder.path() / "none.json"); });
  std::ofstream(folder.path() / "r.json") << "{";
  expect_error(ErrorKind::data, "no reference", [&] { read_reference(folder.path() / "r.json"); });
}

}  // namespace
}  // namespace facet
