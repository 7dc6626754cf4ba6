#include "file/portable_name.hpp"

#include <gtest/gtest.h>
#include <set>

namespace facet {
namespace {

TEST(PortableName, KeepsPlainIdsAndTellsAllOthersApart) {
  EXPECT_EQ(portable_name("learn6"), "learn6");
  EXPECT_EQ(portable_name("frame-01.a_b"), "frame-01.a_b");
  const std::set<std::string> names{portable_name("a/b"), portable_name("a%2Fb"), portable_name("a b"),
                                    portable_name(".a"),  portable_name("a\xff"), portable_name(".."),
                                    portable_name("a\nb")};
  EXPECT_EQ(names.size(), 7u);
  for (const std::string& name : names) {
    EXPECT_EQ(name.find('/'), std::string::npos);
    EXPECT_NE(name.front(), '.');
  }
}

}  // namespace
}  // namespace facet
