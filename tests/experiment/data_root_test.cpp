#include "experiment/data_root.hpp"

#include <gtest/gtest.h>

#include "experiment/experiment_reader.hpp"
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

namespace facet {
namespace {

TEST(DataRoot, OsdIsSearchedForByBothNamesAndThenInTheRootItself) {
  TemporaryFolder folder;
  const std::string root = folder.path().string();
  EXPECT_EQ(locate(named_dataset("osd"), root).root, folder.path());
  std::filesystem::create_directory(folder.path() / "OSD-0.2");
  EXPECT_EQ(locate(named_dataset("osd"), root).root, folder.path() / "OSD-0.2");
  std::filesystem::create_directory(folder.path() / "osd");
  EXPECT_EQ(locate(named_dataset("osd"), root).root, folder.path() / "osd");
}

TEST(DataRoot, AMissingRootIsADataErrorThatSaysHowToGiveIt) {
  expect_error(ErrorKind::data, "--data-root", [] { locate(named_dataset("osd"), std::nullopt); });
  expect_error(ErrorKind::data, "no such folder", [] { locate(named_dataset("osd"), "/nowhere/at/all"); });
}

TEST(DataRoot, OtherRootsAreLeftAlone) {
  DatasetSpec spec = named_dataset("osd");
  spec.root = "/somewhere";
  EXPECT_EQ(locate(spec, "/data").root, "/somewhere");
}

}  // namespace
}  // namespace facet
