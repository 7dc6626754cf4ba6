#include "facet_commands.hpp"

#include <atomic>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include "core/error.hpp"
#include "dataset/benchmark_place.hpp"
#include "dataset/verify.hpp"
#include "experiment/benchmark_text.hpp"
#include "experiment/build_info.hpp"
#include "experiment/config_writer.hpp"
#include "experiment/data_root.hpp"
#include "experiment/dataset_text.hpp"
#include "experiment/environment.hpp"
#include "experiment/merge.hpp"
#include "experiment/method_text.hpp"
#include "experiment/runner.hpp"
#include "experiment/selftest.hpp"
#include "experiment/study_expansion.hpp"
#include "experiment/validation.hpp"
#include "facet_progress.hpp"
#include "pipeline/stage_id.hpp"
#include "score/metrics.hpp"
#include "study/switches.hpp"

namespace {

std::atomic<int> stop_signal = 0;

extern "C" void request_stop(int signal) {
  stop_signal = signal;
}

/// Runs, then prints the report, or how to go on after an interruption.
template <class Run>
int finish_run(const Voice& voice, const Run& run) {
  stop_on_signals();
  const auto log = make_log(voice);
  facet::RunOutcome outcome;
  {
    Progress progress(log, !voice.no_progress && !voice.quiet);
    outcome = run(progress);
  }
  if (stop_signal != 0) {
    log->warn("interrupted; the same command with --resume completes {}", outcome.directory.string());
    return outcome.exit_code;
  }
  fmt::print("{}\nrun directory: {}\nreport: {}\n", facet::render_console(outcome.report),
             outcome.directory.string(), (outcome.directory / "report/report.html").string());
  return outcome.exit_code;
}

/// What truth and prediction must have for a metric: "surfaces; edges, grasps".
std::string needs_of(const facet::Metric& metric) {
  std::string truth, prediction = "labels";
  const auto add = [](std::string& text, bool needed, const char* name) {
    if (needed) text += (text.empty() ? "" : ", ") + std::string(name);
  };
  add(truth, metric.needs_truth.surfaces, "surfaces");
  add(truth, metric.needs_truth.edges, "edges");
  add(truth, metric.needs_truth.masks, "object masks");
  add(truth, metric.needs_truth.poses, "exact planes");
  add(prediction, metric.needs_prediction.edges, "edges");
  add(prediction, metric.needs_prediction.poses, "poses");
  add(prediction, metric.needs_prediction.grasps, "grasps");
  return fmt::format("needs {} of the truth, {} of the prediction{}", truth, prediction,
                     metric.less_is_better ? "; less is better" : "");
}

void print_plan(const facet::Experiment& experiment, const facet::Plan& plan) {
  for (const facet::PlannedDataset& planned : plan.datasets)
    fmt::print("data set {}: {} of {} frames\n", planned.spec.name, planned.frames.size(),
               planned.data->size());
  for (const facet::MethodSpec& method : experiment.methods)
    fmt::print("method {} ({})\n", method.name, method.kind);
  fmt::print("{} frames times methods\n", plan.frame_count());
}

}  // namespace

std::shared_ptr<spdlog::logger> make_log(const Voice& voice) {
  const auto mode = voice.color == "always"  ? spdlog::color_mode::always
                    : voice.color == "never" ? spdlog::color_mode::never
                                             : spdlog::color_mode::automatic;
  auto log = spdlog::stderr_color_mt("facet", mode);
  log->set_pattern("%^%l%$: %v");
  log->set_level(voice.quiet     ? spdlog::level::err
                 : voice.verbose ? spdlog::level::debug
                                 : spdlog::level::info);
  return log;
}

const std::atomic<int>& stop_on_signals() {
  struct sigaction action {};
  action.sa_handler = request_stop;
  action.sa_flags = SA_RESETHAND;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  return stop_signal;
}

int command_run(const facet::RunOptions& options, const Voice& voice, bool dry_run) {
  if (dry_run) {
    const facet::Experiment experiment = facet::expand_study(
        facet::load_experiment(options.config_file, options.overrides).experiment, options.study);
    print_plan(experiment, facet::check_experiment(experiment, options));
    return 0;
  }
  return finish_run(
      voice, [&](Progress& progress) { return facet::run_experiment(options, progress, stop_signal); });
}

int command_merge(const std::vector<std::string>& shards, const facet::RunOptions& options) {
  const facet::RunOutcome outcome =
      facet::merge_runs({shards.begin(), shards.end()}, options.out, options.command);
  fmt::print("{}\nrun directory: {}\n", facet::render_console(outcome.report), outcome.directory.string());
  return outcome.exit_code;
}

int command_score(const facet::ScoreRequest& request, const facet::RunOptions& options, const Voice& voice) {
  return finish_run(voice, [&](Progress& progress) {
    return facet::score_predictions(request, options, progress, stop_signal);
  });
}

int command_selftest(const std::string& dataset, const std::optional<std::string>& data_root,
                     const std::optional<std::string>& annotations) {
  facet::DatasetSpec spec = facet::locate(facet::dataset_called(dataset), facet::find_data_root(data_root));
  if (annotations) spec.annotations = *annotations;
  const facet::Selftest test = facet::run_selftest(spec);
  fmt::print("{}", test.text);
  for (const std::string& problem : test.problems) fmt::print("problem: {}\n", problem);
  if (!test.problems.empty()) return 1;
  return test.annotated > 0 ? 0 : 6;
}

int command_show_config(const std::string& file, const std::vector<std::string>& overrides) {
  fmt::print("{}", facet::write_config_with_origins(facet::load_experiment(file, overrides)));
  return 0;
}

int command_show_defaults() {
  fmt::print("{}", facet::write_default_config());
  return 0;
}

int command_synth(const SynthOptions& options, const Voice& voice) {
  const facet::BenchmarkSpec spec = facet::read_benchmark_spec(options.spec, options.seed);
  fmt::print("{}", facet::describe_estimate(spec, options.jobs));
  std::fflush(stdout);  // before the writing starts
  if (options.dry_run) return 0;
  const std::size_t planned = facet::estimate_benchmark(spec).frames;
  Progress progress(make_log(voice), !voice.no_progress && !voice.quiet);
  const auto summary = facet::write_benchmark(spec, options.out, options.jobs,
                                              [&](std::size_t done) { progress.on_written(done, planned); });
  progress.clear_bar();
  fmt::print("{}", facet::describe_summary(summary, options.out));
  return 0;
}

int command_dataset_list() {
  return command_list("datasets");
}

/// The sets of a benchmark are data sets of their own, maybe of different sensors.
static int verify_parts(facet::DatasetSpec spec) {
  bool whole = true;
  for (const facet::BenchmarkPart& part : facet::benchmark_parts(facet::find_benchmark(spec.root, {}).spec)) {
    spec.name = spec.options["set"] = part.name;
    const facet::DatasetReport report = facet::verify_dataset(spec);
    fmt::print("{}", facet::describe_report(spec, report));
    whole = whole && report.is_whole();
  }
  return whole ? 0 : 4;
}

int command_dataset_report(const std::string& dataset, const std::optional<std::string>& data_root,
                           bool verify) {
  const facet::DatasetSpec spec =
      facet::locate(facet::dataset_called(dataset), facet::find_data_root(data_root));
  if (!verify && spec.reader == "benchmark") {
    fmt::print("{}", facet::describe_benchmark(spec));
    return 0;
  }
  if (spec.reader == "benchmark") return verify_parts(spec);
  if (!verify) {
    const auto data = facet::open_dataset(spec);
    fmt::print("{}", facet::describe_dataset(spec, *data));
    return 0;
  }
  const facet::DatasetReport report = facet::verify_dataset(spec);
  fmt::print("{}", facet::describe_report(spec, report));
  return report.is_whole() ? 0 : 4;
}

int command_dataset_validate(const std::string& dataset, const std::optional<std::string>& data_root,
                             const std::optional<std::string>& masks) {
  const facet::ValidationReport report = facet::validate_named(dataset, data_root, masks);
  fmt::print("{}", facet::describe_validation(report));
  return report.problems.empty() ? 0 : 4;
}

int command_list(const std::string& what) {
  if (what == "methods") fmt::print("{}", facet::describe_methods());
  if (what == "datasets")
    for (const facet::ReaderInfo& reader : facet::readers())
      fmt::print("{:<16} {}\n", reader.name, reader.doc);
  if (what == "stages")
    for (const facet::StageName& stage : facet::stage_names)
      fmt::print("{:<16} {}\n", stage.key, stage.column);
  if (what == "metrics")
    for (const facet::Metric& metric : facet::score_metrics())
      fmt::print("{:<44} {}\n", metric.name, needs_of(metric));
  if (what == "switches")
    for (const facet::AblationSwitch& s : facet::ablation_switches())
      fmt::print("{:<16} {}\n", s.name, s.doc);
  return 0;
}

int command_doctor(const std::optional<std::string>& data_root) {
  fmt::print("{}", facet::environment_json());
  const auto root = facet::find_data_root(data_root);
  if (!root) {
    fmt::print("data root: none; give --data-root or set FACET_DATA\n");
    return 0;
  }
  fmt::print("data root: {}{}\n", *root, std::filesystem::is_directory(*root) ? "" : " (no such folder)");
  return 0;
}

std::string version_text() {
  const facet::BuildInfo& info = facet::build_info();
  return fmt::format("facet {}\ncommit {}{}\ncompiler {}\nflags {} ({})\ncuda {}", info.version, info.commit,
                     info.dirty ? " (dirty)" : "", info.compiler, info.flags, info.build_type, info.cuda);
}
