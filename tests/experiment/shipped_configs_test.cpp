#include <fstream>
#include <gtest/gtest.h>
#include <iterator>

#include "experiment/config_files.hpp"
#include "experiment/config_writer.hpp"

namespace facet {
namespace {

const std::filesystem::path configs = FACET_CONFIGS;

TEST(ShippedConfigs, TheDefaultFileIsTheOneTheCodeWrites) {
  std::ifstream input(configs / "default.yaml");
  const std::string text{std::istreambuf_iterator<char>(input), {}};
  EXPECT_TRUE(text == write_default_config()) << "run: facet show-config --defaults > configs/default.yaml";
}

TEST(ShippedConfigs, TheDefaultFileChangesNothing) {
  Experiment from_file = load_experiment(configs / "default.yaml").experiment;
  Experiment built_in = built_in_experiment();
  from_file.name = built_in.name;
  EXPECT_EQ(write_config(from_file), write_config(built_in));
}

TEST(ShippedConfigs, EveryExperimentCanBeRead) {
  int read = 0;
  for (const auto& entry : std::filesystem::directory_iterator(configs)) {
    if (entry.path().extension() != ".yaml") continue;
    EXPECT_NO_THROW(load_experiment(entry.path())) << entry.path();
    ++read;
  }
  EXPECT_GE(read, 6);
}

}  // namespace
}  // namespace facet
