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

TEST(ShippedConfigs, EveryReproductionCanBeReadAndItsQuickFormHasTheMethodsOfTheFullOne) {
  int read = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(configs / "reproduce")) {
    if (entry.path().extension() != ".yaml") continue;
    EXPECT_NO_THROW(load_experiment(entry.path())) << entry.path();
    ++read;
  }
  EXPECT_GE(read, 11);
  for (const char* name : {"table2.yaml", "clutter.yaml", "invariance.yaml", "thin.yaml"}) {
    const Experiment quick = load_experiment(configs / "reproduce/quick" / name).experiment;
    const Experiment full = load_experiment(configs / "reproduce/full" / name).experiment;
    EXPECT_EQ(quick.name, full.name);
    ASSERT_EQ(quick.methods.size(), full.methods.size());
    ASSERT_EQ(quick.datasets.size(), full.datasets.size());
    for (std::size_t i = 0; i < full.datasets.size(); ++i)
      EXPECT_EQ(quick.datasets[i].name, full.datasets[i].name);
  }
}

}  // namespace
}  // namespace facet
