#include "core/error.hpp"

#include <gtest/gtest.h>

namespace facet {
namespace {

TEST(Error, CarriesItsKindAndMessage) {
  try {
    throw Error(ErrorKind::data, "a.png: is cut short");
  } catch (const std::runtime_error& caught) {
    EXPECT_STREQ(caught.what(), "a.png: is cut short");
    const auto* error = dynamic_cast<const Error*>(&caught);
    ASSERT_NE(error, nullptr);
    EXPECT_EQ(error->kind(), ErrorKind::data);
  }
}

}  // namespace
}  // namespace facet
