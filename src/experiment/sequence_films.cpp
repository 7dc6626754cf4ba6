#include "experiment/sequence_films.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "core/error.hpp"
#include "file/file_bytes.hpp"
#include "file/image_file.hpp"
#include "overlay/film.hpp"
#include "record/run_record.hpp"
#include "record/sequence_summary.hpp"

namespace facet {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t pictures_on_sheet = 12;
constexpr double rate_without_times_hz = 10;

/// The rows of a sequence that have a picture, in the order of time.
std::vector<const FrameRow*> pictured_rows(const RunRecord& run, const SequenceSummary& sequence) {
  std::vector<const FrameRow*> rows;
  for (const FrameRow& row : run.frames)
    if (row.dataset == sequence.dataset && row.method == sequence.method && row.sequence &&
        !row.pictures.empty())
      rows.push_back(&row);
  std::stable_sort(rows.begin(), rows.end(), [](const FrameRow* a, const FrameRow* b) {
    return a->sequence->timestamp_s.value_or(0) < b->sequence->timestamp_s.value_or(0);
  });
  return rows;
}

std::string title_of(const FrameRow& row, const FrameRow& first) {
  if (!row.sequence->timestamp_s || !first.sequence->timestamp_s) return row.frame;
  return fmt::format("{}, {:.2f} s", row.frame, *row.sequence->timestamp_s - *first.sequence->timestamp_s);
}

/// Some of the pictures at even distances, the first and the last among them.
std::vector<TitledPicture> chosen_pictures(const fs::path& run, const std::vector<const FrameRow*>& rows) {
  const std::size_t count = std::min(rows.size(), pictures_on_sheet);
  std::vector<TitledPicture> chosen;
  for (std::size_t i = 0; i < count; ++i) {
    const FrameRow& row = *rows[count > 1 ? i * (rows.size() - 1) / (count - 1) : 0];
    chosen.push_back({title_of(row, *rows.front()), run / row.pictures.front()});
  }
  return chosen;
}

/// Writes the film of a sequence; its rate and its name, or n/a twice.
std::vector<std::string> film_cells(const fs::path& run, const fs::path& film,
                                    const SequenceSummary& sequence,
                                    const std::vector<const FrameRow*>& rows) {
  if (!film_obstacle().empty()) return {"n/a", "n/a"};
  std::vector<fs::path> pictures;
  for (const FrameRow* row : rows) pictures.push_back(run / row->pictures.front());
  const bool timed = sequence.period_s && *sequence.period_s > 0;
  const int rate = write_film(run / film, pictures, timed ? 1 / *sequence.period_s : rate_without_times_hz);
  return {std::to_string(rate), film.generic_string()};
}

/// Film and contact sheet of one sequence; the line of the table that says what there is.
std::vector<std::string> draw_sequence(const fs::path& run, const SequenceSummary& sequence,
                                       const std::vector<const FrameRow*>& rows, ReportSection& section) {
  const std::string stem = (fs::path("films") / sequence.method / sequence.dataset).generic_string();
  std::vector<std::string> cells{sequence.dataset, sequence.method,
                                 fmt::format("{} of {}", rows.size(), sequence.frames)};
  for (std::string& cell : film_cells(run, stem + ".avi", sequence, rows)) cells.push_back(std::move(cell));
  write_png_file(run / (stem + ".png"), draw_contact_sheet(chosen_pictures(run, rows)));
  section.pictures.push_back({fmt::format("{} / {}", sequence.dataset, sequence.method), stem + ".png"});
  cells.push_back(stem + ".png");
  return cells;
}

}  // namespace

SequenceFilms make_films(const fs::path& directory) {
  const RunRecord run = read_run(directory);
  const std::vector<SequenceSummary> sequences = summarize_sequences(run.frames);
  if (sequences.empty())
    throw Error(ErrorKind::not_measured, printable(directory) + ": no sequence was processed");
  SequenceFilms films;
  ReportSection section;
  section.title = "Sequences";
  ReportTable table;
  table.header = {"sequence", "method", "pictures", "per second", "film", "contact sheet"};
  for (const SequenceSummary& sequence : sequences) {
    const std::vector<const FrameRow*> rows = pictured_rows(run, sequence);
    if (!rows.empty()) table.rows.push_back(draw_sequence(directory, sequence, rows, section));
    films.is_complete = films.is_complete && !rows.empty();
  }
  if (table.rows.empty())
    throw Error(
        ErrorKind::not_measured,
        printable(directory) + ": no pictures of a sequence are kept; run it with outputs.overlays: true");
  section.tables.push_back(std::move(table));
  if (!film_obstacle().empty()) {
    section.paragraphs.push_back("No films: " + film_obstacle() + ".");
    films.is_complete = false;
  }
  films.report = {"Facet: sequences of " + run.manifest.experiment, {std::move(section)}};
  write_file_atomically(directory / "report/films.html", render_html(films.report, directory));
  return films;
}

}  // namespace facet
