#include "experiment/benchmark_text.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "dataset/benchmark_place.hpp"
#include "experiment/typed_value.hpp"
#include "file/file_bytes.hpp"

namespace facet {
namespace {

std::string duration_text(double seconds) {
  return seconds < 90 ? fmt::format("{:.0f} s", std::max(1.0, seconds))
                      : fmt::format("{:.0f} min", seconds / 60);
}

std::string part_text(const DatasetSpec& spec, const BenchmarkPart& part) {
  std::string name = part.name;
  std::replace(name.begin(), name.end(), '/', '_');
  std::string text =
      fmt::format("set     {}: {} frames, {}{}\n", part.name, part.frames.size(),
                  enum_name(part.set.sensor.model), part.set.frames > 1 ? ", one sequence" : "");
  text += fmt::format("        {{name: {}, reader: benchmark, root: {}, set: {}}}\n", name,
                      printable(spec.root), part.name);
  for (const PlannedFrame& frame : part.frames) text += "  " + frame.id + '\n';
  return text;
}

}  // namespace

std::string describe_benchmark(const DatasetSpec& spec) {
  const BenchmarkPlace place = find_benchmark(spec.root, spec.options);
  std::string text =
      fmt::format("{}: synthetic benchmark, {}\nreader  benchmark\nroot    {}\nfolder  {}\n", spec.name,
                  place.rendered ? "a frame is rendered when it is first read, and kept" : "written",
                  printable(spec.root), printable(place.folder));
  text +=
      "An entry of an experiment's `datasets` stands below each set; without `set` it has all sets, if\n"
      "they are of one sensor and no sequences.\n";
  for (const BenchmarkPart& part : benchmark_parts(place.spec)) text += part_text(spec, part);
  return text;
}

std::string describe_estimate(const BenchmarkSpec& spec, int jobs) {
  const BenchmarkEstimate estimate = estimate_benchmark(spec);
  return fmt::format("{}: {} frames, about {:.0f} MB and {} with {} thread{}\n", spec.name, estimate.frames,
                     std::max(1.0, estimate.megabytes), duration_text(estimate.seconds / jobs), jobs,
                     jobs > 1 ? "s" : "");
}

std::string describe_summary(const BenchmarkSummary& summary, const std::filesystem::path& out) {
  std::string text = fmt::format("{} frames in {} data sets are written below {}\n", summary.frames,
                                 summary.folders.size(), printable(out));
  for (const auto& folder : summary.folders) text += fmt::format("  {}\n", printable(folder));
  for (const std::string& line : summary.not_available) text += fmt::format("not written: {}\n", line);
  for (const std::string& line : summary.shortfalls) text += fmt::format("shortfall: {}\n", line);
  return text + fmt::format("{} frames not available, {} frames with fewer objects than asked for\n",
                            summary.not_available.size(), summary.shortfalls.size());
}

}  // namespace facet
