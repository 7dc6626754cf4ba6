#include "experiment/publish_rows.hpp"

#include <algorithm>
#include <map>

#include "experiment/sweep_plan.hpp"
#include "record/outcome_csv.hpp"
#include "record/sequence_summary.hpp"
#include "report/timing_summary.hpp"
#include "study/ablation_effects.hpp"

namespace facet {
namespace {

/// Pose scores are wanted by themselves only where some truth has planes.
ScoreGroups wanted_scores(const Experiment& experiment, const std::vector<FrameRow>& rows) {
  const ScoreOptions& score = experiment.score;
  const bool known = std::any_of(rows.begin(), rows.end(),
                                 [](const FrameRow& row) { return row.score && row.score->annotated.poses; });
  const bool poses = score.pose == PoseScoring::on || (score.pose == PoseScoring::automatic && known);
  return {score.surfaces, score.edges, score.objects, poses};
}

void publish_ablation(const RunDirectory& directory, const Experiment& experiment, const RunRecord& run) {
  const AblationPlan plan = plan_ablations(experiment.ablations, experiment.methods);
  directory.publish("metrics/ablation.json",
                    ablation_to_json(ablation_effects(plan, run.frames, run.manifest.datasets)));
  directory.publish("timing/ablation.json", ablation_to_json(ablation_costs(plan, run)));
}

/// A level of what a data set varies; without an axis the whole of every data set.
struct SweepLevel {
  std::string dataset, axis;
  std::optional<double> value;
  auto operator<=>(const SweepLevel&) const = default;
};

SweepRow row_at(const SweepPoint& point, const std::string& dataset, const std::string& measure) {
  SweepRow row;
  row.method = point.method.name;
  row.base = point.base;
  row.settings = point.settings;
  row.dataset = dataset;
  row.measure = measure;
  return row;
}

/// Scores of the points on the data sets, or on the frames of one level.
void add_scores(const std::vector<SweepPoint>& points, const std::vector<ScoreResult>& results,
                const SweepLevel& level, std::vector<SweepRow>& rows) {
  for (const SweepPoint& point : points)
    for (const ScoreResult& result : results) {
      if (result.method != point.method.name) continue;
      if (!level.axis.empty() && result.dataset != level.dataset) continue;
      for (const std::string& measure : AblationOptions{}.metrics) {
        const ScoreCell& cell = result.cell(measure);
        SweepRow& row = rows.emplace_back(row_at(point, result.dataset, measure));
        row.axis = level.axis;
        row.level = level.value;
        row.value = cell.value;
        row.lo = cell.lo;
        row.hi = cell.hi;
        row.reason = cell.reason;
      }
    }
}

/// The frames of every level of what data sets vary.
std::map<SweepLevel, std::vector<FrameRow>> rows_by_level(const std::vector<FrameRow>& rows) {
  std::map<SweepLevel, std::vector<FrameRow>> levels;
  for (const FrameRow& row : rows)
    if (!row.axis.empty()) levels[{row.dataset, row.axis, row.level}].push_back(row);
  return levels;
}

void publish_sweep(const RunDirectory& directory, const Experiment& experiment, const RunRecord& run) {
  std::vector<SweepRow> scores, times;
  const std::vector<SweepPoint> points = plan_sweep(experiment);
  add_scores(points, run.scores, {}, scores);
  for (const auto& [level, rows] : rows_by_level(run.frames))
    add_scores(points,
               score_results_from_json(
                   metrics_summary_json(run.manifest, rows, wanted_scores(experiment, run.frames))),
               level, scores);
  const std::vector<TimingSummary> timing = summarize_timing(run.timing);
  for (const SweepPoint& point : points)
    for (const TimingSummary& summary : timing) {
      if (summary.method != point.method.name) continue;
      times.push_back(row_at(point, summary.dataset, "total_ms"));
      times.back().value = summary.total.mean_ms;
    }
  directory.publish("metrics/sweep.json", sweep_to_json(scores));
  directory.publish("timing/sweep.json", sweep_to_json(times));
}

}  // namespace

void publish_rows(const RunDirectory& directory, const Experiment& experiment, const Manifest& manifest,
                  const std::vector<FrameRow>& rows) {
  std::string lines;
  for (const FrameRow& row : rows) lines += to_json_line(row);
  directory.publish("frames.jsonl", lines);
  directory.publish("metrics/frames.csv", frames_csv(rows));
  directory.publish("metrics/surfaces.csv", surfaces_csv(rows));
  directory.publish("metrics/edges.csv", edges_csv(rows));
  if (const auto sequences = summarize_sequences(rows); !sequences.empty())
    directory.publish("metrics/sequences.json", sequences_json(sequences));
  directory.publish("metrics/summary.json",
                    metrics_summary_json(manifest, rows, wanted_scores(experiment, rows)));
}

void publish_study(const RunDirectory& directory, const Experiment& experiment, Study study) {
  if (study == Study::none) return;
  const RunRecord run = read_run(directory.path());
  if (study == Study::ablation) publish_ablation(directory, experiment, run);
  if (study == Study::sweep) publish_sweep(directory, experiment, run);
}

void count_rows(const std::vector<FrameRow>& rows, Manifest& manifest) {
  for (const FrameRow& row : rows) {
    manifest.frames_ok += row.status == FrameStatus::ok;
    manifest.frames_data_error += row.status == FrameStatus::data_error;
    manifest.frames_method_error += row.status == FrameStatus::method_error;
  }
}

}  // namespace facet
