#include "stream_command.hpp"

#include <fmt/format.h>
#include <memory>
#include <optional>

#include "experiment/stream_run.hpp"
#include "facet_commands.hpp"
#include "facet_progress.hpp"

namespace {

struct StreamArguments {
  facet::RunOptions run;
  Voice voice;
  std::string rate, policy;
  std::optional<int> frames;
  std::optional<double> seconds;
  std::optional<int> seed;
};

/// A number, or the name of a pace.
void set_rate(StreamArguments& a) {
  if (a.rate.empty()) return;
  const bool is_pace = a.rate == "recorded" || a.rate == "fastest";
  a.run.overrides.push_back("stream.pace=" + (is_pace ? a.rate : "fixed"));
  if (!is_pace) a.run.overrides.push_back("stream.rate_hz=" + a.rate);
}

/// Either limit takes the place of both that the file sets.
void set_limits(StreamArguments& a) {
  if (!a.frames && !a.seconds) return;
  a.run.overrides.push_back(fmt::format("stream.frames={}", a.frames.value_or(0)));
  a.run.overrides.push_back(fmt::format("stream.seconds={}", a.seconds.value_or(0)));
}

int run_stream(StreamArguments& a) {
  set_rate(a);
  set_limits(a);
  if (!a.policy.empty()) a.run.overrides.push_back("stream.policy=" + a.policy);
  if (a.seed) a.run.overrides.push_back(fmt::format("seed={}", *a.seed));
  const std::atomic<int>& stop_signal = stop_on_signals();
  facet::RunOutcome outcome;
  {
    Progress progress(make_log(a.voice), !a.voice.no_progress && !a.voice.quiet);
    outcome = facet::run_stream_experiment(a.run, progress, stop_signal);
  }
  fmt::print("{}\nrun directory: {}\nreport: {}\n", facet::render_console(outcome.report),
             outcome.directory.string(), (outcome.directory / "report/report.html").string());
  return outcome.exit_code;
}

}  // namespace

void add_stream_command(CLI::App& app, std::function<int()>& chosen,
                        const std::vector<std::string>& command_line) {
  const auto arguments = std::make_shared<StreamArguments>();
  StreamArguments& a = *arguments;
  a.run.command = command_line;
  CLI::App* command = app.add_subcommand(
      "stream", "frames through filters joined by queues: latency, throughput, drops at a sensor's rate");
  command->add_option("experiment", a.run.config_file, "experiment file (YAML) with a section `stream`")
      ->required();
  command->add_option("--rate", a.rate, "frames per second, `recorded` or `fastest`")
      ->check(CLI::PositiveNumber | CLI::IsMember({"recorded", "fastest"}));
  command->add_option("--frames", a.frames, "frames offered; those in memory are taken in turn")
      ->check(CLI::PositiveNumber);
  command->add_option("--seconds", a.seconds, "how long frames are offered")->check(CLI::PositiveNumber);
  command->add_option("--policy", a.policy, "where the first queue is full: block or drop");
  command->add_option("--backend", a.run.backend, "cpu, cuda or auto")
      ->check(CLI::IsMember({"cpu", "cuda", "auto"}))
      ->capture_default_str();
  command->add_option("--set", a.run.overrides, "KEY=VALUE over the experiment file, repeatable")
      ->allow_extra_args(false);
  command->add_option("--seed", a.seed, "the same as --set seed=N")->check(CLI::NonNegativeNumber);
  command->add_option("--data-root", a.run.data_root, "folder that holds the data sets; beats FACET_DATA");
  command->add_option("-o,--out", a.run.out, "results root")->capture_default_str();
  command->add_option("--filter", a.run.filter,
                      "only frames whose dataset/frame matches this regular expression");
  command->add_option("--limit", a.run.limit, "only the first N frames of every data set")
      ->check(CLI::PositiveNumber);
  command->add_flag("-q,--quiet", a.voice.quiet, "errors alone on stderr");
  command->add_flag("--no-progress", a.voice.no_progress, "no progress on stderr");
  command->callback([&chosen, arguments] { chosen = [arguments] { return run_stream(*arguments); }; });
}
