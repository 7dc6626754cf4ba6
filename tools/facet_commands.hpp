#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiment/run_options.hpp"

/// How much is said on stderr, and how.
struct Voice {
  bool quiet = false;
  bool verbose = false;
  bool no_progress = false;
  std::string color = "auto";
};

// The commands: each writes its result to stdout and returns the exit code; errors are thrown as
// facet::Error.

int command_run(const facet::RunOptions& options, const Voice& voice, bool dry_run);
int command_report(const std::vector<std::string>& run_directories);
int command_show_config(const std::string& file, const std::vector<std::string>& overrides);
int command_show_defaults();
int command_dataset_list();
/// `dataset` is the name of a reader, or a folder with dataset.yaml; `verify` reads every frame.
int command_dataset_report(const std::string& dataset, const std::optional<std::string>& data_root,
                           bool verify);
int command_list(const std::string& what);
int command_doctor(const std::optional<std::string>& data_root);
std::string version_text();
