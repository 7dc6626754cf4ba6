#include "reproduce_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>

#include "core/error.hpp"
#include "facet_commands.hpp"
#include "facet_progress.hpp"
#include "paper/reproduce.hpp"

namespace {

int run_reproduce(const facet::ReproduceRequest& request, const Voice& voice) {
  const std::atomic<int>& stop_signal = stop_on_signals();
  facet::ReproduceOutcome outcome;
  try {
    Progress progress(make_log(voice), !voice.no_progress && !voice.quiet);
    outcome = facet::reproduce(request, progress, stop_signal);
  } catch (const facet::Error&) {
    if (stop_signal == 0) throw;
    return 128 + stop_signal;  // the finished runs are kept, the page is not written
  }
  fmt::print("{}\nreport: {}\n", facet::render_console(outcome.report),
             (outcome.directory / "report/report.html").string());
  for (const std::string& difference : outcome.differences)
    fmt::print(stderr, "facet: differs from the reference: {}\n", difference);
  return outcome.exit_code;
}

}  // namespace

void add_reproduce_command(CLI::App& app, std::function<int()>& chosen) {
  const auto request = std::make_shared<facet::ReproduceRequest>();
  const auto voice = std::make_shared<Voice>();
  CLI::App* command = app.add_subcommand(
      "reproduce", "the paper's tables, figures and numeric claims, ours beside the paper's");
  command->add_option("target", request->targets,
                      fmt::format("{}, or all (the default)", fmt::join(facet::reproduce_targets(), ", ")));
  command->add_flag("--full", request->full, "every scene instead of a few of each kind");
  command->add_flag("--check", request->check,
                    "compare the scores with results/reference/; 1 where one differs");
  command->add_option("-o,--out", request->run.out, "results root")->capture_default_str();
  command->add_option("-j,--jobs", request->run.jobs, "frames at a time where nothing is timed")
      ->check(CLI::Range(1, 1024));
  command->add_option("--data-root", request->run.data_root,
                      "folder that holds the data sets; beats FACET_DATA");
  command->add_flag("-q,--quiet", voice->quiet, "errors alone on stderr");
  command->add_flag("--no-progress", voice->no_progress, "no progress on stderr");
  command->callback(
      [&chosen, request, voice] { chosen = [request, voice] { return run_reproduce(*request, *voice); }; });
}
