#include "experiment/dataset_text.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "experiment/experiment_reader.hpp"
#include "file/file_bytes.hpp"

namespace facet {
namespace {

std::string heading(const DatasetSpec& spec, const std::string& description) {
  std::string text = fmt::format("{}: {}\nreader  {}\n", spec.name, description, spec.reader);
  if (!spec.root.empty()) text += fmt::format("root    {}\n", printable(spec.root));
  return text;
}

std::string group_line(const FrameGroup& group) {
  std::string text = fmt::format("{:<8}{} of {}", group.name, group.found(), group.expected);
  if (!group.absent.empty()) text += fmt::format(", absent: {}", fmt::join(group.absent, " "));
  return text + '\n';
}

/// The reader whose layout a path has.
std::string reader_of(const std::filesystem::path& path) {
  for (const ReaderInfo& reader : readers())
    if (reader.recognises != nullptr && reader.recognises(path)) return std::string(reader.name);
  return "folder";
}

}  // namespace

DatasetSpec with_shipped_annotations(DatasetSpec spec) {
  const std::filesystem::path folder = std::filesystem::path(FACET_DATASETS) / spec.name / "annotations";
  if (std::filesystem::is_directory(folder)) spec.annotations = folder;
  return spec;
}

DatasetSpec dataset_called(const std::string& name_or_folder) {
  std::vector<std::string> names;
  for (const ReaderInfo& reader : readers()) names.emplace_back(reader.name);
  if (std::find(names.begin(), names.end(), name_or_folder) != names.end())
    return with_shipped_annotations(named_dataset(name_or_folder));
  const std::string reader = reader_of(name_or_folder);
  if (reader == "folder" && !std::filesystem::is_directory(name_or_folder))
    throw Error(ErrorKind::data,
                fmt::format("{}: neither one of the data sets {} nor a folder, nor the spec of a benchmark",
                            name_or_folder, fmt::join(names, ", ")));
  DatasetSpec spec;
  spec.reader = reader;
  spec.root = name_or_folder;
  spec.name = std::filesystem::weakly_canonical(spec.root).stem().string();
  return spec;
}

std::string describe_dataset(const DatasetSpec& spec, const Dataset& data) {
  std::string text = heading(spec, data.description());
  text += fmt::format("sensor  {}\nframes  {}{}\n", enum_name(data.sensor()), data.size(),
                      data.is_sequence() ? ", one sequence" : "");
  for (const std::string& gap : data.absent()) text += fmt::format("note    {}\n", escaped_utf8(gap));
  if (!spec.root.empty())
    text += fmt::format("entry   {{name: {}, reader: {}, root: {}}}\n", spec.name, spec.reader,
                        printable(spec.root));
  for (std::size_t i = 0; i < data.size(); ++i) text += "  " + escaped_utf8(data.frame_id(i)) + '\n';
  return text;
}

std::string describe_report(const DatasetSpec& spec, const DatasetReport& report) {
  std::string text = heading(spec, report.description);
  text += fmt::format("sensor  {}\nframes  {}, {} readable, {} with colour, {} with object masks\n",
                      enum_name(report.sensor), report.frames, report.readable, report.with_color,
                      report.with_masks);
  for (const auto& size : report.image_sizes)
    text += fmt::format("size    {} x {} px: {} frames\n", size.size.width, size.size.height, size.frames);
  text += fmt::format("depth   {:.3f} to {:.3f} m, {:.1f} % missing\n", report.nearest_m, report.farthest_m,
                      100 * report.missing_share);
  for (const FrameGroup& group : report.groups) text += group_line(group);
  text += fmt::format("sums    {} checksums compared\n", report.checksums_compared);
  for (const std::string& note : report.notes) text += "note    " + note + '\n';
  for (const auto& problem : report.problems)
    text += fmt::format("problem {}: {}\n", problem.subject, problem.message);
  return text + (report.is_whole() ? "whole\n" : "NOT whole\n");
}

}  // namespace facet
