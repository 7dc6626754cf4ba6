#include "report_commands.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <memory>

#include "experiment/gallery_pictures.hpp"
#include "experiment/sequence_films.hpp"
#include "report/write_report.hpp"

namespace {

struct ReportOptions {
  std::vector<std::string> runs;
  std::vector<std::string> formats{"md", "html", "tex"};
};

int run_report(const ReportOptions& options) {
  for (const std::string& directory : options.runs) {
    const facet::Report report = facet::write_report(directory, options.formats);
    fmt::print("{}\nreports: {}\n", facet::render_console(report),
               (std::filesystem::path(directory) / "report").string());
  }
  return 0;
}

int run_gallery(const facet::GalleryRequest& request) {
  const facet::Report report = facet::make_gallery(request);
  fmt::print("{}\ngallery: {}\n", facet::render_console(report),
             (request.run / "report/gallery.html").string());
  return 0;
}

/// 6 where a film is missing.
int run_films(const std::filesystem::path& run) {
  const facet::SequenceFilms films = facet::make_films(run);
  fmt::print("{}\nfilms: {}\n", facet::render_console(films.report), (run / "report/films.html").string());
  return films.is_complete ? 0 : 6;
}

void add_report(CLI::App& app, std::function<int()>& chosen) {
  const auto options = std::make_shared<ReportOptions>();
  CLI::App* report = app.add_subcommand("report", "render stored runs again, without images");
  report->add_option("run", options->runs, "run directories")->required();
  report->add_option("--format", options->formats, "md, html, tex, csv, json; several with commas between")
      ->delimiter(',')
      ->capture_default_str();
  report->callback([&chosen, options] { chosen = [options] { return run_report(*options); }; });
}

void add_gallery(CLI::App& app, std::function<int()>& chosen) {
  const auto request = std::make_shared<facet::GalleryRequest>();
  const auto film = std::make_shared<bool>(false);
  CLI::App* gallery =
      app.add_subcommand("gallery", "the worst frames of a run as pictures, or its sequences as films");
  gallery->add_option("run", request->run, "run directory")->required();
  auto* films = gallery->add_flag("--film", *film, "films and contact sheets of the sequences, instead");
  gallery->add_option("--vs", request->baseline, "another run: the frames that are worst against it")
      ->excludes(films);
  gallery->add_option("--worst", request->worst, "frames of every data set and method")
      ->check(CLI::PositiveNumber)
      ->capture_default_str()
      ->excludes(films);
  gallery->add_option("--by", request->metric, "score that orders them, see `facet list metrics`")
      ->capture_default_str()
      ->excludes(films);
  gallery->add_option("--data-root", request->data_root, "folder that holds the data sets; beats FACET_DATA");
  gallery->callback([&chosen, request, film] {
    chosen = [request, film] { return *film ? run_films(request->run) : run_gallery(*request); };
  });
}

}  // namespace

void add_report_commands(CLI::App& app, std::function<int()>& chosen) {
  add_report(app, chosen);
  add_gallery(app, chosen);
}
