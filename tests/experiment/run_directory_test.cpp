#include "experiment/run_directory.hpp"

#include <gtest/gtest.h>

#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

namespace facet {
namespace {

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
