#include "paper/reproduce.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "experiment/build_info.hpp"
#include "experiment/run_directory.hpp"
#include "file/file_bytes.hpp"
#include "paper/reference.hpp"
#include "paper/reproduction.hpp"
#include "report/write_report.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;

struct Target {
  std::string_view name;
  Reproduced (*make)(Reproduction&);
};
constexpr Target targets[]{
    {"table2", reproduce_table2},     {"table3", reproduce_table3},     {"claims", reproduce_claims},
    {"figure3", reproduce_figure3},   {"figure4", reproduce_figure4},   {"figure5", reproduce_figure5},
    {"figure6", reproduce_figure6},   {"figure10", reproduce_figure10}, {"figure12", reproduce_figure12},
    {"figure13", reproduce_figure13}, {"figure14", reproduce_figure14}};

/// The targets that are asked for, in the order of the paper's sections as listed above.
std::vector<Target> chosen_targets(const std::vector<std::string>& names) {
  const auto known = [](const std::string& name) {
    return name == "all" || std::any_of(std::begin(targets), std::end(targets),
                                        [&](const Target& t) { return t.name == name; });
  };
  for (const std::string& name : names)
    if (!known(name))
      throw Error(ErrorKind::usage,
                  fmt::format("reproduce {}: there are {}, all", name, fmt::join(reproduce_targets(), ", ")));
  std::vector<Target> chosen;
  for (const Target& target : targets)
    if (names.empty() || std::find(names.begin(), names.end(), "all") != names.end() ||
        std::find(names.begin(), names.end(), target.name) != names.end())
      chosen.push_back(target);
  return chosen;
}

void write_results(const RunDirectory& directory, const Report& report, const ReferenceTables& exact,
                   const std::string& latex) {
  directory.publish("report/report.html", render_html(report, directory.path()));
  directory.publish("report/report.md", render_markdown(report));
  directory.publish("report/report.csv", render_csv(report));
  directory.publish("report/report.json", render_json(report));
  if (!latex.empty()) directory.publish("report/tables.tex", latex_document(latex));
  directory.publish("reference.json", to_json(exact));
  directory.become_latest();
}

ReportSection provenance(const Reproduction& reproduction, bool full) {
  ReportSection section;
  section.title = "Provenance";
  section.paragraphs.push_back(
      fmt::format("{} scenes; build {}.", full ? "All" : "A part of the", build_identity()));
  for (const std::string& note : reproduction.notes()) section.paragraphs.push_back(note);
  return section;
}

}  // namespace

std::vector<std::string_view> reproduce_targets() {
  std::vector<std::string_view> names;
  for (const Target& target : targets) names.push_back(target.name);
  return names;
}

ReproduceOutcome reproduce(const ReproduceRequest& request, RunObserver& observer,
                           const std::atomic<int>& stop_signal) {
  const std::vector<Target> chosen = chosen_targets(request.targets);
  const char* size = request.full ? "full" : "quick";
  const fs::path reference = fs::path(FACET_REFERENCE) / fmt::format("reproduce_{}.json", size);
  const ReferenceTables expected = request.check ? read_reference(reference) : ReferenceTables();
  const RunDirectory directory =
      RunDirectory::create(request.run.out, "reproduce", size, build_info().name());
  Reproduction reproduction(request.full, request.run, directory.path(), observer, stop_signal);
  ReproduceOutcome outcome;
  outcome.directory = directory.path();
  outcome.report.title = "The paper, reproduced";
  ReferenceTables exact;
  std::string latex;
  for (const Target& target : chosen) {
    observer.on_note(fmt::format("reproducing {}", target.name));
    Reproduced made = target.make(reproduction);
    if (!made.is_measured) outcome.exit_code = 6;
    latex += made.latex;
    if (!made.exact.empty()) exact[std::string(target.name)] = std::move(made.exact);
    outcome.report.sections.push_back(std::move(made.section));
  }
  outcome.report.sections.push_back(provenance(reproduction, request.full));
  write_results(directory, outcome.report, exact, latex);
  if (request.check) outcome.differences = differences_from(expected, exact);
  if (!outcome.differences.empty()) outcome.exit_code = 1;
  return outcome;
}

}  // namespace facet
