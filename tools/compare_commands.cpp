#include "compare_commands.hpp"

#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <optional>

#include "compare/benchmark_json.hpp"
#include "compare/comparison_report.hpp"
#include "core/error.hpp"
#include "experiment/baseline.hpp"
#include "experiment/gate_rounds.hpp"
#include "experiment/policy_reader.hpp"
#include "experiment/run_directory.hpp"
#include "facet_commands.hpp"
#include "facet_progress.hpp"
#include "file/file_bytes.hpp"

namespace {

namespace fs = std::filesystem;

/// Where the result goes beside stdout.
struct ResultFiles {
  std::string json, markdown, junit, action_benchmark, google_benchmark;
  std::string ci;
};

void add_result_files(CLI::App& command, ResultFiles& files) {
  command.add_option("--json", files.json, "write every value to FILE");
  command.add_option("--markdown", files.markdown, "write a comment for a pull request to FILE");
  command.add_option("--junit", files.junit, "write a JUnit report to FILE");
  command.add_option("--action-benchmark", files.action_benchmark,
                     "write the times to FILE for github-action-benchmark (customSmallerIsBetter)");
  command.add_option("--google-benchmark", files.google_benchmark,
                     "write the times to FILE in the shape of Google Benchmark");
  command.add_option("--ci", files.ci, "annotations for this service on stdout")
      ->check(CLI::IsMember({"github"}));
}

void write_results(const facet::Comparison& comparison, const facet::GateDecision& decision,
                   const facet::ComparedNames& names, const facet::RunRecord& run, const ResultFiles& files) {
  const facet::Report report = facet::make_comparison_report(comparison, decision, names);
  const auto write = [](const std::string& file, const auto& make) {
    if (!file.empty()) facet::write_file_atomically(file, std::string_view(make()));
  };
  write(files.json, [&] { return facet::comparison_json(comparison, decision, names); });
  write(files.markdown, [&] { return facet::render_markdown(report); });
  write(files.junit, [&] { return facet::junit_xml(comparison, decision); });
  write(files.action_benchmark, [&] { return facet::action_benchmark_json(run); });
  write(files.google_benchmark, [&] { return facet::google_benchmark_json(run); });
  fmt::print("{}", facet::render_console(report));
  if (files.ci == "github") fmt::print("{}", facet::github_annotations(decision));
}

/// Says on stderr what fails and what is doubtful; the exit code.
int conclude(const facet::GateDecision& decision) {
  for (const std::string& warning : decision.warnings) fmt::print(stderr, "warning: {}\n", warning);
  for (const std::string& failure : decision.failures) fmt::print(stderr, "facet: {}\n", failure);
  switch (decision.result) {
    case facet::GateResult::passed:
      return 0;
    case facet::GateResult::failed:
      return 1;
    default:
      return 6;
  }
}

struct CompareOptions {
  std::string before, after;
  ResultFiles files;
};

int run_compare(const CompareOptions& o) {
  const facet::RunRecord before = facet::read_run(o.before), after = facet::read_run(o.after);
  const facet::Comparison comparison =
      facet::compare_rounds({&before, 1}, {&after, 1}, facet::comparing_policy());
  const facet::GateDecision decision = facet::decide_comparison(comparison);
  write_results(comparison, decision, {o.before, o.after}, after, o.files);
  return conclude(decision);
}

struct GateOptions {
  std::string target;  ///< run directory, or experiment file
  std::string baseline, confirm, policy;
  std::string binary, baseline_binary;
  int rounds = 5;
  facet::RunOptions run;
  ResultFiles files;
};

facet::RunRecord read_baseline(const GateOptions& o) {
  const fs::path folder = o.baseline.empty() ? facet::default_baseline(o.target) : fs::path(o.baseline);
  if (!fs::exists(folder / "manifest.json"))
    throw facet::Error(
        facet::ErrorKind::not_measured,
        fmt::format("{}: no baseline; make a run one with facet baseline update RUN --reason TEXT",
                    facet::printable(folder)));
  return facet::read_run(folder);
}

int gate_stored(const GateOptions& o, const facet::Policy& policy) {
  const facet::RunRecord after = facet::read_run(o.target), before = read_baseline(o);
  facet::Comparison comparison = facet::compare_rounds({&before, 1}, {&after, 1}, policy);
  if (!o.confirm.empty()) {
    const facet::RunRecord again = facet::read_run(o.confirm);
    facet::confirm(comparison, facet::compare_rounds({&before, 1}, {&again, 1}, policy));
  }
  const facet::GateDecision decision = facet::decide(comparison, policy);
  write_results(comparison, decision, {"baseline", o.target}, after, o.files);
  return conclude(decision);
}

facet::GateRequest request_of(const GateOptions& o) {
  facet::GateRequest request{o.binary, o.baseline_binary, {o.target}, {}, o.rounds};
  const auto add = [&](const char* option, const std::string& value) {
    request.arguments.insert(request.arguments.end(), {option, value});
  };
  for (const std::string& change : o.run.overrides) add("--set", change);
  if (o.run.data_root) add("--data-root", *o.run.data_root);
  if (!o.run.filter.empty()) add("--filter", o.run.filter);
  if (o.run.limit) add("--limit", std::to_string(*o.run.limit));
  request.out = o.run.out / "gate" / facet::utc_now(true);
  return request;
}

int gate_binaries(const GateOptions& o, const facet::Policy& policy) {
  const facet::GateRequest request = request_of(o);
  Progress progress(make_log({}), true);
  const facet::GateRounds rounds = facet::run_gate_rounds(request, "round", progress);
  facet::Comparison comparison = facet::compare_rounds(rounds.before, rounds.after, policy);
  if (facet::decide(comparison, policy).result == facet::GateResult::failed && comparison.vanished.empty()) {
    progress.on_note("something is worse; measuring again to confirm it");
    const facet::GateRounds again = facet::run_gate_rounds(request, "confirmation", progress);
    facet::confirm(comparison, facet::compare_rounds(again.before, again.after, policy));
  }
  const facet::GateDecision decision = facet::decide(comparison, policy);
  write_results(comparison, decision, {o.baseline_binary, o.binary}, rounds.after.front(), o.files);
  return conclude(decision);
}

int run_gate(const GateOptions& o) {
  const facet::Policy policy = facet::read_policy(o.policy);
  if (o.binary.empty() != o.baseline_binary.empty())
    throw facet::Error(facet::ErrorKind::usage, "gate: --binary and --baseline-binary go together");
  return o.binary.empty() ? gate_stored(o, policy) : gate_binaries(o, policy);
}

void add_compare(CLI::App& app, std::function<int()>& chosen) {
  const auto o = std::make_shared<CompareOptions>();
  CLI::App* command = app.add_subcommand("compare", "paired differences between two runs, with intervals");
  command->add_option("before", o->before, "run directory")->required();
  command->add_option("after", o->after, "run directory")->required();
  add_result_files(*command, o->files);
  command->callback([o, &chosen] { chosen = [o] { return run_compare(*o); }; });
}

void add_gate(CLI::App& app, std::function<int()>& chosen) {
  const auto o = std::make_shared<GateOptions>();
  CLI::App* command =
      app.add_subcommand("gate", "fail where accuracy or latency got worse than a policy allows");
  command->add_option("run", o->target, "run directory; with --binary, the experiment file to run")
      ->required();
  command->add_option("--policy", o->policy, "what may change by how much (YAML)")->required();
  auto* binary = command->add_option("--binary", o->binary, "build to judge, run here");
  command
      ->add_option("--baseline", o->baseline,
                   "run directory, or what `baseline update` wrote; default: beside RUN")
      ->excludes(binary);
  command
      ->add_option("--confirm", o->confirm, "a second run of the same build: latency fails only if both do")
      ->excludes(binary);
  command->add_option("--baseline-binary", o->baseline_binary, "build to compare with, run here in turn");
  command->add_option("--rounds", o->rounds, "runs of each build")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_option("-o,--out", o->run.out, "results root")->capture_default_str();
  command->add_option("--set", o->run.overrides, "as for run")->allow_extra_args(false);
  command->add_option("--data-root", o->run.data_root, "as for run");
  command->add_option("--filter", o->run.filter, "as for run");
  command->add_option("--limit", o->run.limit, "as for run")->check(CLI::PositiveNumber);
  add_result_files(*command, o->files);
  command->callback([o, &chosen] { chosen = [o] { return run_gate(*o); }; });
}

struct BaselineOptions {
  std::string run, reason, folder, who = facet::user_at_machine();
};

int update_baseline(const BaselineOptions& o) {
  const fs::path folder = o.folder.empty() ? facet::default_baseline(o.run) : fs::path(o.folder);
  const facet::BaselineEntry entry = facet::update_baseline(o.run, folder, o.reason, o.who);
  fmt::print("{} is the baseline in {}\n{} by {}: {}\n", entry.run, facet::printable(folder), entry.when_utc,
             entry.who, entry.reason);
  return 0;
}

void add_baseline(CLI::App& app, std::function<int()>& chosen) {
  CLI::App* baseline = app.add_subcommand("baseline", "what later runs are held to");
  baseline->require_subcommand(1);
  const auto o = std::make_shared<BaselineOptions>();
  CLI::App* update =
      baseline->add_subcommand("update", "make a run the baseline, and record who, when and why");
  update->add_option("run", o->run, "run directory")->required();
  update->add_option("--reason", o->reason, "why")->required();
  update->add_option("--to", o->folder, "folder of the baseline; default: beside the run");
  update->add_option("--who", o->who, "who decides")->capture_default_str();
  update->callback([o, &chosen] { chosen = [o] { return update_baseline(*o); }; });
}

}  // namespace

void add_compare_commands(CLI::App& app, std::function<int()>& chosen) {
  add_compare(app, chosen);
  add_gate(app, chosen);
  add_baseline(app, chosen);
}
