#include "experiment/run_directory.hpp"

#include <gtest/gtest.h>
#include <set>

#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

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

TEST(RunDirectory, TwoRunsOfOneSecondGetFoldersOfTheirOwn) {
  TemporaryFolder folder;
  const auto a = RunDirectory::create(folder.path(), "e", "0123456789", "abc");
  const auto b = RunDirectory::create(folder.path(), "e", "0123456789", "abc");
  EXPECT_NE(a.path(), b.path());
}

TEST(RunDirectory, FindsTheNewestOfTheSameConfigurationAndBuild) {
  TemporaryFolder folder;
  EXPECT_FALSE(RunDirectory::find(folder.path(), "e", "0123456789", "abc"));
  RunDirectory::create(folder.path(), "e", "0123456789", "abc");
  const auto newest = RunDirectory::create(folder.path(), "e", "0123456789", "abc").path();
  RunDirectory::create(folder.path(), "e", "0123456789", "abc-dirty");
  RunDirectory::create(folder.path(), "e", "9999999999", "abc");
  const auto found = RunDirectory::find(folder.path(), "e", "0123456789", "abc");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->path(), newest);
}

TEST(RunDirectory, LatestFollowsTheNewestRun) {
  TemporaryFolder folder;
  RunDirectory::create(folder.path(), "e", "0123456789", "abc").become_latest();
  const auto second = RunDirectory::create(folder.path(), "e", "0123456789", "abc");
  second.become_latest();
  EXPECT_EQ(std::filesystem::canonical(folder.path() / "e/latest"),
            std::filesystem::canonical(second.path()));
}

TEST(LineLog, CannotBeOpenedInAFolderThatIsNotThere) {
  expect_error(ErrorKind::internal, "nowhere/log", [] { LineLog("/nowhere/log"); });
}

}  // namespace
}  // namespace facet
