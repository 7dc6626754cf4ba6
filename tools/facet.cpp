// The command line: options in, one command called, errors to exit codes.

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <fmt/format.h>
#include <string>
#include <vector>

#include "compare_commands.hpp"
#include "core/error.hpp"
#include "exit_code.hpp"
#include "facet_commands.hpp"
#include "report_commands.hpp"
#include "reproduce_command.hpp"
#include "stream_command.hpp"

namespace {

struct Arguments {
  facet::RunOptions run;
  Voice voice;
  std::optional<int> seed;
  bool dry_run = false;
  bool keep_going = false;
  bool defaults = false;
  std::string file;
  std::string dataset;
  std::optional<std::string> masks;
  std::optional<std::string> annotations;
  facet::ScoreRequest score;
  SynthOptions synth;
  std::string list_what;
  std::vector<std::string> run_directories;
};

void add_config_options(CLI::App& command, Arguments& a) {
  command.add_option("--set", a.run.overrides, "KEY=VALUE over the experiment file, repeatable")
      ->allow_extra_args(false);
  command.add_option("--seed", a.seed, "the same as --set seed=N")->check(CLI::NonNegativeNumber);
}

void add_data_root(CLI::App& command, Arguments& a) {
  command.add_option("--data-root", a.run.data_root, "folder that holds the data sets; beats FACET_DATA");
}

void add_voice(CLI::App& command, Arguments& a) {
  auto* quiet = command.add_flag("-q,--quiet", a.voice.quiet, "errors alone on stderr");
  command.add_flag("-v,--verbose", a.voice.verbose, "every frame on stderr")->excludes(quiet);
  command.add_flag("--no-progress", a.voice.no_progress, "no progress on stderr");
  command.add_option("--color", a.voice.color, "auto, always or never")
      ->check(CLI::IsMember({"auto", "always", "never"}));
}

/// What every command that takes frames through methods is told.
void add_frame_options(CLI::App& command, Arguments& a) {
  add_data_root(command, a);
  command.add_option("-o,--out", a.run.out, "results root")->capture_default_str();
  command.add_option("-j,--jobs", a.run.jobs, "frames at a time in the accuracy pass")
      ->check(CLI::Range(1, 1024));
  command.add_option("--filter", a.run.filter,
                     "only frames whose dataset/frame matches this regular expression");
  command.add_option("--limit", a.run.limit, "only the first N frames of every data set")
      ->check(CLI::PositiveNumber);
  command.add_flag("--resume", a.run.resume, "complete the newest run of the same configuration and build");
  auto* fast = command.add_flag("--fail-fast", a.run.fail_fast, "stop at the first failed frame");
  command.add_flag("--keep-going", a.keep_going, "go on after failed frames (the default)")->excludes(fast);
  command.add_option("--max-failures", a.run.max_failures, "failed frames that are forgiven")
      ->check(CLI::NonNegativeNumber)
      ->excludes(fast);
}

void add_run(CLI::App& app, Arguments& a) {
  for (const auto& [name, study, doc] :
       {std::tuple{"run", facet::Study::none, "run methods over data sets, time them, write a run directory"},
        std::tuple{"ablate", facet::Study::ablation, "the same over the switches of the section `ablation`"},
        std::tuple{"sweep", facet::Study::sweep, "the same over the values of the section `sweep`"}}) {
    CLI::App* run = app.add_subcommand(name, doc);
    run->add_option("experiment", a.file, "experiment file (YAML)")->required();
    add_config_options(*run, a);
    add_frame_options(*run, a);
    run->add_flag("--dry-run", a.dry_run, "say what would run and stop");
    run->add_option_function<std::string>(
        "--shard", [&a](const std::string& text) { a.run.shard = facet::parse_shard(text); },
        "only part I of N, to be joined by facet merge");
    run->add_option("--backend", a.run.backend, "cpu, cuda or auto")
        ->check(CLI::IsMember({"cpu", "cuda", "auto"}))
        ->capture_default_str();
    add_voice(*run, a);
    run->callback([&a, study = study] { a.run.study = study; });
  }
}

void add_scoring(CLI::App& app, Arguments& a) {
  CLI::App* score = app.add_subcommand("score", "score the predictions that any program has written");
  score->add_option("--pred", a.score.predictions, "folder with FRAME.labels.png and the like")->required();
  score->add_option("--data", a.score.dataset, "a data set's name, its folder, or a benchmark's spec")
      ->required();
  score->add_option("--annotations", a.annotations, "folder of truth that wins over the data set's own");
  add_frame_options(*score, a);
  add_voice(*score, a);
  CLI::App* test = app.add_subcommand("selftest", "score the truth of a data set: 100 % everywhere");
  test->add_option("dataset", a.dataset, "a data set's name, its folder, or a benchmark's spec")->required();
  test->add_option("--annotations", a.annotations, "folder of truth that wins over the data set's own");
  add_data_root(*test, a);
}

void add_synth(CLI::App& app, Arguments& a) {
  CLI::App* synth = app.add_subcommand("synth", "write a synthetic benchmark: frames, truth, checksums");
  synth->add_option("spec", a.synth.spec, "spec (YAML), such as configs/synth/quick.yaml")->required();
  auto* out = synth->add_option("-o,--out", a.synth.out, "folder to write, new or empty");
  synth->add_option("--seed", a.synth.seed, "in place of the spec's")->check(CLI::Range(0.0, 9e15));
  synth->add_option("-j,--jobs", a.synth.jobs, "frames at a time; the bytes do not depend on it")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  synth->add_flag("--dry-run", a.synth.dry_run, "say how much it is and stop")->excludes(out);
  add_voice(*synth, a);
}

void add_others(CLI::App& app, Arguments& a) {
  CLI::App* show =
      app.add_subcommand("show-config", "print the merged experiment and where each value comes from");
  auto* file = show->add_option("experiment", a.file, "experiment file (YAML)");
  show->add_flag("--defaults", a.defaults, "print every key with its default instead")->excludes(file);
  add_config_options(*show, a);

  CLI::App* dataset = app.add_subcommand("dataset", "look at data sets");
  dataset->require_subcommand(1);
  dataset->add_subcommand("list", "the readers there are");
  for (const auto& [name, doc] : {std::pair{"info", "what a data set is and its frames"},
                                  std::pair{"verify", "read every frame, compare checksums and counts"}}) {
    CLI::App* command = dataset->add_subcommand(name, doc);
    command
        ->add_option("dataset", a.dataset,
                     "a reader's name, a folder with dataset.yaml, or a synthetic benchmark (spec or folder)")
        ->required();
    add_data_root(*command, a);
  }
  CLI::App* check =
      dataset->add_subcommand("validate", "check annotations against every rule of their format");
  check->add_option("dataset", a.dataset, "a reader's name, a written benchmark, or a folder of annotations")
      ->required();
  check->add_option("--masks", a.masks, "folder of object masks NAME.png, where they lie apart");
  add_data_root(*check, a);
  CLI::App* list = app.add_subcommand("list", "what there is, one line each");
  list->add_option("what", a.list_what, "methods, datasets, stages, metrics or switches")
      ->required()
      ->check(CLI::IsMember({"methods", "datasets", "stages", "metrics", "switches"}));
  add_data_root(*app.add_subcommand("doctor", "what this machine and this binary have"), a);
}

void add_merge(CLI::App& app, Arguments& a) {
  CLI::App* merge = app.add_subcommand("merge", "join the shards of a run");
  merge->add_option("run", a.run_directories, "run directories of all shards")->required();
  merge->add_option("-o,--out", a.run.out, "results root")->capture_default_str();
}

int dispatch(const CLI::App& app, Arguments& a) {
  if (app.got_subcommand("merge")) return command_merge(a.run_directories, a.run);
  if (a.seed) a.run.overrides.push_back(fmt::format("seed={}", *a.seed));
  if (app.got_subcommand("run") || app.got_subcommand("ablate") || app.got_subcommand("sweep")) {
    a.run.config_file = a.file;
    return command_run(a.run, a.voice, a.dry_run);
  }
  if (app.got_subcommand("score")) {
    if (a.annotations) a.score.annotations = *a.annotations;
    return command_score(a.score, a.run, a.voice);
  }
  if (app.got_subcommand("selftest")) return command_selftest(a.dataset, a.run.data_root, a.annotations);
  if (app.got_subcommand("show-config")) {
    if (a.defaults) return command_show_defaults();
    if (a.file.empty())
      throw facet::Error(facet::ErrorKind::usage, "show-config: give an experiment or --defaults");
    return command_show_config(a.file, a.run.overrides);
  }
  if (app.got_subcommand("synth")) {
    if (a.synth.out.empty() && !a.synth.dry_run)
      throw facet::Error(facet::ErrorKind::usage, "synth: give --out DIR, or --dry-run");
    return command_synth(a.synth, a.voice);
  }
  if (app.got_subcommand("list")) return command_list(a.list_what);
  if (app.got_subcommand("doctor")) return command_doctor(a.run.data_root);
  const CLI::App* dataset = app.get_subcommand("dataset");
  if (dataset->got_subcommand("list")) return command_dataset_list();
  if (dataset->got_subcommand("validate"))
    return command_dataset_validate(a.dataset, a.run.data_root, a.masks);
  return command_dataset_report(a.dataset, a.run.data_root, dataset->got_subcommand("verify"));
}

}  // namespace

int main(int argc, char** argv) {
  // A file too large and a closed pipe are errors of a write, not the end of the program.
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  Arguments arguments;
  arguments.run.command.assign(argv, argv + argc);
  CLI::App app("facet: batch evaluation of surface segmentation in depth images", "facet");
  app.set_version_flag("--version", version_text());
  app.require_subcommand(1);
  add_run(app, arguments);
  add_merge(app, arguments);
  add_scoring(app, arguments);
  add_synth(app, arguments);
  add_others(app, arguments);
  std::function<int()> chosen;
  add_compare_commands(app, chosen);
  add_report_commands(app, chosen);
  add_reproduce_command(app, chosen);
  add_stream_command(app, chosen, arguments.run.command);
  try {
    app.parse(argc, argv);
    if (chosen) return chosen();
    return dispatch(app, arguments);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  } catch (const facet::Error& e) {
    fmt::print(stderr, "facet: {}\n", e.what());
    return exit_code_of(e.kind());
  } catch (const std::exception& e) {
    fmt::print(stderr, "facet: internal error: {}\n", e.what());
    return 70;
  }
}
