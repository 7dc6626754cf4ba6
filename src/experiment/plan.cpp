#include "experiment/plan.hpp"

#include <fmt/format.h>
#include <map>
#include <regex>

#include "core/error.hpp"
#include "experiment/data_root.hpp"
#include "experiment/dataset_text.hpp"
#include "file/file_bytes.hpp"

namespace facet {
namespace {

std::regex compile_filter(const std::string& filter) {
  try {
    return std::regex(filter);
  } catch (const std::regex_error& e) {
    throw Error(ErrorKind::usage, fmt::format("--filter {}: no regular expression: {}", filter, e.what()));
  }
}

PlannedDataset open_planned(const DatasetSpec& spec, const RunOptions& options, const std::regex& filter) {
  PlannedDataset planned;
  planned.spec = locate(spec, find_data_root(options.data_root));
  planned.data = open_dataset(planned.spec);
  if (planned.data->is_sequence() && planned.spec.annotations.empty()) {
    planned.spec = with_shipped_annotations(planned.spec);
    if (!planned.spec.annotations.empty()) planned.data = open_dataset(planned.spec);
  }
  if (planned.data->size() == 0)
    throw Error(ErrorKind::data,
                fmt::format("data set '{}': no frames in {}", spec.name, printable(planned.spec.root)));
  for (std::size_t i = 0; i < planned.data->size(); ++i) {
    if (options.limit && planned.frames.size() >= static_cast<std::size_t>(*options.limit)) break;
    if (options.filter.empty() || std::regex_search(spec.name + '/' + planned.data->frame_id(i), filter))
      planned.frames.push_back(i);
  }
  return planned;
}

void add_units(Plan& plan, std::size_t method, std::size_t dataset) {
  const PlannedDataset& planned = plan.datasets[dataset];
  if (planned.data->is_sequence()) {
    if (!planned.frames.empty()) plan.units.push_back({method, dataset, planned.frames});
    return;
  }
  for (const std::size_t frame : planned.frames) plan.units.push_back({method, dataset, {frame}});
}

/// Keeps the units of one shard. All methods of a frame are in the same, so that their times are taken beside
/// each other.
void keep_shard(Plan& plan, const Shard& shard) {
  if (shard.is_whole()) return;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> number;  // data set and first frame -> position
  for (const Unit& unit : plan.units) number.try_emplace({unit.dataset, unit.frames.front()}, number.size());
  const auto count = static_cast<std::size_t>(shard.count), kept = static_cast<std::size_t>(shard.index - 1);
  std::erase_if(plan.units, [&](const Unit& unit) {
    return number.at({unit.dataset, unit.frames.front()}) % count != kept;
  });
  if (plan.units.empty())
    throw Error(ErrorKind::not_measured, fmt::format("--shard {}: there are only {} frames and sequences",
                                                     shard.text(), number.size()));
}

}  // namespace

std::size_t Plan::frame_count() const {
  std::size_t count = 0;
  for (const Unit& unit : units) count += unit.frames.size();
  return count;
}

Plan make_plan(const Experiment& experiment, const RunOptions& options) {
  const std::regex filter = compile_filter(options.filter);
  Plan plan;
  for (const DatasetSpec& spec : experiment.datasets)
    plan.datasets.push_back(open_planned(spec, options, filter));
  for (std::size_t method = 0; method < experiment.methods.size(); ++method)
    for (std::size_t dataset = 0; dataset < plan.datasets.size(); ++dataset) add_units(plan, method, dataset);
  if (plan.units.empty())
    throw Error(ErrorKind::not_measured, fmt::format("no frame is left after --filter {}", options.filter));
  keep_shard(plan, options.shard);
  return plan;
}

}  // namespace facet
