#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <spdlog/logger.h>
#include <string>
#include <vector>

#include "experiment/run_options.hpp"
#include "experiment/score_run.hpp"

/// How much is said on stderr, and how.
struct Voice {
  bool quiet = false;
  bool verbose = false;
  bool no_progress = false;
  std::string color = "auto";
};
/// The log on stderr.
std::shared_ptr<spdlog::logger> make_log(const Voice& voice);
/// From here on the first signal ends a run at the next frame, a second one the program. Returns where its
/// number will be, 0 until then.
const std::atomic<int>& stop_on_signals();

// The commands: each writes its result to stdout and returns the exit code; errors are thrown as
// facet::Error.

int command_run(const facet::RunOptions& options, const Voice& voice, bool dry_run);
/// Joins the shards of a run.
int command_merge(const std::vector<std::string>& shards, const facet::RunOptions& options);
/// Scores the predictions that anyone's program wrote.
int command_score(const facet::ScoreRequest& request, const facet::RunOptions& options, const Voice& voice);
/// Scores the truth of a data set as a prediction; 1 where that is not perfect.
int command_selftest(const std::string& dataset, const std::optional<std::string>& data_root,
                     const std::optional<std::string>& annotations);
int command_show_config(const std::string& file, const std::vector<std::string>& overrides);
int command_show_defaults();
/// What `facet synth` is told.
struct SynthOptions {
  std::string spec;
  std::string out;
  std::optional<std::uint64_t> seed;
  int jobs = 1;
  bool dry_run = false;
};
int command_synth(const SynthOptions& options, const Voice& voice);
int command_dataset_list();
/// `dataset` is the name of a reader, or a folder with dataset.yaml; `verify` reads every frame.
int command_dataset_report(const std::string& dataset, const std::optional<std::string>& data_root,
                           bool verify);
/// Prints every problem of the annotations; `masks` is a folder of object masks, where they lie apart.
int command_dataset_validate(const std::string& dataset, const std::optional<std::string>& data_root,
                             const std::optional<std::string>& masks);
int command_list(const std::string& what);
int command_doctor(const std::optional<std::string>& data_root);
std::string version_text();
