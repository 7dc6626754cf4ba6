#include "report/frame_points.hpp"

#include "score/metrics.hpp"

namespace facet {

std::optional<double> FramePoint::score(const std::string& name) const {
  const Metric& metric = score_metric(name);
  if (!row->score || !metric.is_annotated(*row->score)) return std::nullopt;
  if (!row->score->failed && !metric.is_predicted(*row->score)) return std::nullopt;
  return metric.value(metric.sums(*row->score));
}

FrameTimesMs segmentation_times(const TimingTable& table) {
  std::vector<bool> left_out;
  for (const std::string& stage : table.stages) left_out.push_back(stage == "pose" || stage == "grasps");
  std::map<std::tuple<std::string, std::string, std::string>, std::pair<double, int>> sums;
  for (const TimingSample& s : table.samples) {
    if (s.phase != TimingPhase::steady) continue;
    double ms = s.total_ms;
    for (std::size_t i = 0; i < s.stage_ms.size(); ++i)
      if (left_out[i]) ms -= s.stage_ms[i];
    auto& [sum, count] = sums[{s.dataset, s.frame, s.method}];
    sum += ms;
    ++count;
  }
  FrameTimesMs times;
  for (const auto& [key, sum] : sums) times[key] = sum.first / sum.second;
  return times;
}

std::vector<FramePoint> frame_points(const RunRecord& run, const std::string& dataset,
                                     const std::string& method) {
  const FrameTimesMs times = segmentation_times(run.timing);
  std::vector<FramePoint> points;
  for (const FrameRow& row : run.frames) {
    if (row.dataset != dataset || row.method != method) continue;
    FramePoint point;
    point.row = &row;
    point.has_truth = row.score && row.score->annotated.surfaces;
    if (!point.has_truth && row.status != FrameStatus::ok) continue;
    point.surfaces = point.has_truth ? row.score->clutter.surfaces : row.surfaces;
    point.objects = row.score ? row.score->clutter.objects : 0;
    if (const auto found = times.find({row.dataset, row.frame, row.method}); found != times.end())
      point.segmentation_ms = found->second;
    points.push_back(point);
  }
  return points;
}

}  // namespace facet
