#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiment/shard.hpp"

namespace facet {

/// Which study of an experiment file runs.
enum class Study {
  none,      ///< the methods as they are
  ablation,  ///< those of the section `ablation`
  sweep,     ///< those of the section `sweep`
};

/// What the command line says beside the experiment file; none of it changes a frame's result.
struct RunOptions {
  std::filesystem::path config_file;
  Study study = Study::none;
  std::vector<std::string> overrides;  ///< --set KEY=VALUE
  std::optional<std::string> data_root;
  std::filesystem::path out = "results";
  std::string backend = "auto";  ///< cpu, cuda or auto
  std::string filter;            ///< regular expression searched in "dataset/frame"; empty = all
  std::optional<int> limit;      ///< first N frames of every data set
  Shard shard;                   ///< the part of the run that is done
  int jobs = 1;
  int max_failures = 0;  ///< more failed frames than this make the run fail
  bool resume = false;
  bool fail_fast = false;
  std::vector<std::string> command;  ///< as it was typed, for the record
};

}  // namespace facet
