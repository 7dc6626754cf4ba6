#include "stream/stream_options.hpp"

#include <gtest/gtest.h>

#include "support/expect_error.hpp"

namespace facet {
namespace {

void expect_rejected(const std::string& rule, std::vector<StreamFilter> filters) {
  StreamOptions options;
  options.filters = std::move(filters);
  expect_error(ErrorKind::config, rule, [&] { validate(options); });
}

TEST(StreamOptions, TheDefaultFiltersAreAllStagesInOrder) {
  EXPECT_NO_THROW(validate({}));
  EXPECT_EQ(StreamOptions{}.filters.back().until, StageId::objects);
}

TEST(StreamOptions, EveryStageMustRunOnceAndInOrder) {
  expect_rejected("the last filter must run until objects", {});
  expect_rejected("the last filter must run until objects", {{"a", StageId::pose, 1}});
  expect_rejected("a later stage",
                  {{"a", StageId::pose, 1}, {"b", StageId::pose, 1}, {"c", StageId::objects, 1}});
  expect_rejected("a later stage",
                  {{"a", StageId::pose, 1}, {"b", StageId::fill, 1}, {"c", StageId::objects, 1}});
}

TEST(StreamOptions, TheTemporalAverageNeedsItsFramesInOrder) {
  expect_rejected("the first filter must have one thread", {{"all", StageId::objects, 2}});
}

TEST(StreamOptions, FiltersHaveNamesOfTheirOwn) {
  expect_rejected("'a' is the name of two", {{"a", StageId::fill, 1}, {"a", StageId::objects, 1}});
}

}  // namespace
}  // namespace facet
