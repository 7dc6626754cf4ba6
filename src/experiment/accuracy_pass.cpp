#include "experiment/accuracy_pass.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <utility>

#include "method/registry.hpp"
#include "record/run_record.hpp"

namespace facet {
namespace {

/// The methods of one thread, made when first needed: (method, data set) -> object.
using ThreadMethods = std::map<std::pair<std::size_t, std::size_t>, std::unique_ptr<Method>>;

std::string log_line(const FrameRow& row, bool finished_before) {
  nlohmann::ordered_json json;
  json["time"] = utc_now();
  json["event"] = finished_before ? "kept" : "frame";
  json["dataset"] = row.dataset;
  json["frame"] = row.frame;
  json["method"] = row.method;
  json["status"] = std::string(status_name(row.status));
  json["reason"] = row.reason;
  return json.dump() + '\n';
}

}  // namespace

AccuracyPass::AccuracyPass(const Experiment& experiment, const Plan& plan, const RunIdentity& identity,
                           const RunDirectory& directory, const RunOptions& options, RunObserver& observer,
                           const std::atomic<int>& stop_signal)
    : experiment_(experiment),
      plan_(plan),
      directory_(directory),
      options_(options),
      observer_(observer),
      stop_signal_(stop_signal),
      work_(experiment, plan, identity, directory.path()),
      event_log_(directory.path() / "log.jsonl") {
  restore_finished();
  rows_log_ = std::make_unique<LineLog>(directory.path() / "frames.jsonl");
}

void AccuracyPass::restore_finished() {
  std::ifstream input(directory_.path() / "frames.jsonl", std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(input), {}};
  std::vector<FrameRow> kept;
  for (FrameRow& row : frame_rows_from_jsonl(text))
    if (row.status == FrameStatus::ok) kept.push_back(std::move(row));
  work_.keep_finished(kept);
  // Starts the checkpoint anew, without failed frames, which are tried again, and without a line that was cut
  // off.
  std::string lines;
  for (const FrameRow& row : kept) lines += to_json_line(row);
  directory_.publish("frames.jsonl", lines);
}

MethodContext AccuracyPass::context_of(const Unit& unit) const {
  const PlannedDataset& planned = plan_.datasets[unit.dataset];
  return {planned.data->sensor(), static_cast<std::uint64_t>(experiment_.seed), 1,
          directory_.path() / "programs" / experiment_.methods[unit.method].name / planned.spec.name,
          plan_.backend.backend};
}

/// What has to be done once per method and data set.
void AccuracyPass::prepare_methods() const {
  std::map<std::pair<std::size_t, std::size_t>, std::vector<Unit>> groups;
  for (const Unit& unit : plan_.units) groups[{unit.method, unit.dataset}].push_back(unit);
  for (const auto& [key, units] : groups) {
    const MethodSpec& spec = experiment_.methods[key.first];
    const auto prepare = find_method_kind(spec).prepare;
    if (prepare == nullptr) continue;
    MethodFrames asked{*plan_.datasets[key.second].data, {}};
    for (const Unit& unit : units)
      asked.frames.insert(asked.frames.end(), unit.frames.begin(), unit.frames.end());
    prepare(spec, asked, context_of(units.front()));
  }
}

std::vector<FrameRow> AccuracyPass::run() {
  prepare_methods();
  tbb::task_arena arena(options_.jobs);
  arena.execute([&] {
    tbb::enumerable_thread_specific<ThreadMethods> methods;
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, plan_.units.size(), 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
          for (std::size_t i = range.begin(); i < range.end() && !should_stop(); ++i) {
            const Unit& unit = plan_.units[i];
            auto& method = methods.local()[{unit.method, unit.dataset}];
            if (!method) method = make_method(experiment_.methods[unit.method], context_of(unit));
            // Isolated: while a method waits for threads of its own, this one must not begin another unit
            // with it.
            tbb::this_task_arena::isolate([&] { run_unit(unit, *method); });
          }
        },
        tbb::simple_partitioner());
  });
  std::sort(rows_.begin(), rows_.end(), row_before);
  return rows_;
}

void AccuracyPass::run_unit(const Unit& unit, Method& method) {
  method.reset_history();
  StabilityTracker tracker;
  for (const std::size_t frame : unit.frames) {
    if (should_stop()) return;
    const auto [row, finished_before] = work_.evaluate(unit, frame, method, tracker);
    add_row(row, finished_before);
  }
}

void AccuracyPass::add_row(const FrameRow& row, bool finished_before) {
  const std::lock_guard lock(mutex_);
  if (!finished_before) rows_log_->append(to_json_line(row));
  event_log_.append(log_line(row, finished_before));
  rows_.push_back(row);
  new_rows_ += !finished_before;
  if (options_.fail_fast && row.status != FrameStatus::ok) failed_fast_ = true;
  observer_.on_frame(row, rows_.size(), plan_.frame_count());
}

}  // namespace facet
