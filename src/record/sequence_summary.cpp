#include "record/sequence_summary.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "record/optional_json.hpp"
#include "score/intervals.hpp"

namespace facet {
namespace {

/// A plane that is followed for fewer frames has no mean worth a comparison.
constexpr std::size_t least_frames_of_a_track = 5;

using Rows = std::vector<const FrameRow*>;

Spread spread_of(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  return {sorted_quantile(values, 0.5), sorted_quantile(values, 0.95), values.size()};
}

std::optional<double> ratio(double part, double whole) {
  return whole > 0 ? std::optional(part / whole) : std::nullopt;
}

void summarize_times(const Rows& rows, SequenceSummary& summary) {
  std::vector<double> times, distances;
  for (const FrameRow* row : rows)
    if (row->sequence->timestamp_s) times.push_back(*row->sequence->timestamp_s);
  summary.with_time = times.size();
  std::sort(times.begin(), times.end());
  for (std::size_t i = 1; i < times.size(); ++i) distances.push_back(times[i] - times[i - 1]);
  if (distances.empty()) return;
  summary.duration_s = times.back() - times.front();
  summary.period_s = spread_of(distances).p50;
}

void summarize_windows(const Rows& rows, SequenceSummary& summary) {
  double frames = 0, age_s = 0;
  std::size_t aged = 0;
  for (const FrameRow* row : rows) {
    const WindowUse& window = row->sequence->window;
    frames += window.frames;
    if (window.start != WindowStart::continued)
      ++summary.starts[std::string(window_start_names[static_cast<std::size_t>(window.start)])];
    if (!window.mean_age_s) continue;
    ++aged;
    age_s += *window.mean_age_s;
    summary.most_age_s = std::max(summary.most_age_s.value_or(0), *window.mean_age_s);
  }
  summary.window_frames = ratio(frames, static_cast<double>(rows.size()));
  summary.mean_age_s = ratio(age_s, static_cast<double>(aged));
}

void summarize_overlaps(const Rows& rows, SequenceSummary& summary) {
  double iou = 0, regions = 0, covered_px = 0, region_px = 0;
  for (const FrameRow* row : rows) {
    const FrameStability& s = row->sequence->stability;
    summary.compared += s.compared;
    summary.in_world += s.compared && s.in_world;
    summary.before += static_cast<std::size_t>(s.before);
    summary.kept += static_cast<std::size_t>(s.kept);
    iou += s.iou_sum;
    regions += s.regions;
    covered_px += s.covered_px;
    region_px += s.region_px;
  }
  summary.region_iou = ratio(iou, regions);
  summary.covering = ratio(covered_px, region_px);
  const std::size_t lost = summary.before - summary.kept;
  // The estimate for lives that the ends of a sequence cut off: time seen per loss.
  if (summary.period_s && lost > 0)
    summary.life_s = *summary.period_s * static_cast<double>(summary.before) / static_cast<double>(lost);
}

/// Deviations of a plane's poses from their mean.
void add_jitter(const std::vector<const TrackedPlane*>& track, std::vector<double>& normals_deg,
                std::vector<double>& centres_mm) {
  if (track.size() < least_frames_of_a_track) return;
  Vec3d normal, centre;
  for (const TrackedPlane* plane : track) {
    normal = normal + plane->normal;
    centre = centre + (1.0 / static_cast<double>(track.size())) * plane->centre_m;
  }
  if (norm(normal) <= 0) return;
  normal = normalized(normal);
  for (const TrackedPlane* plane : track) {
    normals_deg.push_back(std::atan2(norm(cross(normal, plane->normal)), dot(normal, plane->normal)) * 180 /
                          std::numbers::pi);
    centres_mm.push_back(1000 * norm(plane->centre_m - centre));
  }
}

void summarize_jitter(const Rows& rows, SequenceSummary& summary) {
  std::map<std::pair<bool, int>, std::vector<const TrackedPlane*>> tracks;
  for (const FrameRow* row : rows)
    for (const TrackedPlane& plane : row->sequence->stability.planes)
      tracks[{row->sequence->stability.in_world, plane.track}].push_back(&plane);
  std::vector<double> normals_deg, centres_mm;
  for (const auto& [key, track] : tracks) add_jitter(track, normals_deg, centres_mm);
  summary.normal_jitter_deg = spread_of(std::move(normals_deg));
  summary.centre_jitter_mm = spread_of(std::move(centres_mm));
}

nlohmann::ordered_json json_of(const Spread& spread) {
  return {{"p50", nlohmann::ordered_json(spread.p50)},
          {"p95", nlohmann::ordered_json(spread.p95)},
          {"n", spread.n}};
}

}  // namespace

std::vector<SequenceSummary> summarize_sequences(const std::vector<FrameRow>& rows) {
  std::map<std::pair<std::string, std::string>, Rows> groups;
  for (const FrameRow& row : rows)
    if (row.sequence) groups[{row.dataset, row.method}].push_back(&row);
  std::vector<SequenceSummary> summaries;
  for (const auto& [key, group] : groups) {
    SequenceSummary summary{.dataset = key.first, .method = key.second, .frames = group.size()};
    for (const FrameRow* row : group) {
      summary.with_truth += !row->truth_source.empty();
      summary.with_pose += row->sequence->camera_posed;
    }
    summarize_times(group, summary);
    summarize_windows(group, summary);
    summarize_overlaps(group, summary);
    summarize_jitter(group, summary);
    summaries.push_back(std::move(summary));
  }
  return summaries;
}

std::string sequences_json(const std::vector<SequenceSummary>& summaries) {
  auto json = nlohmann::ordered_json::array();
  for (const SequenceSummary& s : summaries) {
    nlohmann::ordered_json entry;
    entry["dataset"] = s.dataset;
    entry["method"] = s.method;
    entry["frames"] = s.frames;
    entry["frames_with_truth"] = s.with_truth;
    entry["frames_with_time"] = s.with_time;
    entry["frames_with_pose"] = s.with_pose;
    entry["duration_s"] = s.duration_s;
    entry["period_s"] = s.period_s;
    entry["window_frames"] = s.window_frames;
    entry["window_mean_age_s"] = s.mean_age_s;
    entry["window_most_age_s"] = s.most_age_s;
    entry["window_starts"] = s.starts;
    entry["pairs_compared"] = s.compared;
    entry["pairs_in_world"] = s.in_world;
    entry["region_iou"] = s.region_iou;
    entry["covering"] = s.covering;
    entry["regions_before"] = s.before;
    entry["regions_kept"] = s.kept;
    entry["life_s"] = s.life_s;
    entry["normal_jitter_deg"] = json_of(s.normal_jitter_deg);
    entry["centre_jitter_mm"] = json_of(s.centre_jitter_mm);
    json.push_back(std::move(entry));
  }
  return nlohmann::ordered_json{{"sequences", std::move(json)}}.dump(2) + '\n';
}

}  // namespace facet
