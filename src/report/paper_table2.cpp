#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <optional>

#include "report/run_report.hpp"
#include "score/metric_column.hpp"

namespace facet {
namespace {

/// Hits of a frame's score, and what there is to find; nothing where the method does not yield what counts.
struct Found {
  std::optional<Tally> objects, surfaces, edges;
};
Found found_in(const FrameScore& score, const PredictedParts& yields) {
  const GraspScore& g = score.grasps;
  Found found;
  if (yields.edges) found.edges = score.edges.recall_6px.graspable;
  if (yields.regions) {
    found.surfaces = g.surfaces;
    if (yields.poses) found.objects = yields.grasps ? g.objects_grasp : g.objects_pose;
  } else if (yields.grasps) {
    found.surfaces = g.surfaces_by_grasp;
    found.objects = g.objects_by_grasp;
  }
  return found;
}
Found there_is_in(const FrameScore& score) {
  return {score.grasps.objects_grasp, score.grasps.surfaces, score.edges.recall_6px.graspable};
}

struct Group {
  const char* name;
  std::optional<Tally> Found::*tally;
};
constexpr Group groups[]{
    {"objects", &Found::objects}, {"surfaces", &Found::surfaces}, {"edges", &Found::edges}};

/// One frame under every method.
using Scene = std::map<std::string, const FrameRow*>;
using SceneKey = std::pair<std::string, std::string>;  // kind, frame

bool has_truth(const FrameRow& row) {
  return row.score && row.score->annotated.surfaces;
}

std::map<SceneKey, Scene> scenes_of(const RunRecord& run, const std::string& dataset) {
  std::map<SceneKey, Scene> scenes;
  for (const FrameRow& row : run.frames)
    if (row.dataset == dataset) scenes[{row.kind, row.frame}][row.method] = &row;
  return scenes;
}

/// What a method yields in any of its frames: one frame may show nothing.
using Yields = std::map<std::string, PredictedParts>;
Yields yields_of(const std::map<SceneKey, Scene>& scenes) {
  Yields yields;
  for (const auto& [key, scene] : scenes)
    for (const auto& [method, row] : scene) {
      if (!has_truth(*row) || row->score->failed) continue;
      PredictedParts& all = yields.try_emplace(method, PredictedParts{.regions = false}).first->second;
      all = united(all, row->score->predicted);
    }
  return yields;
}

using Sums = std::map<std::pair<const char*, std::string>, Tally>;

void add_scene(ReportTable& table, const SceneKey& key, const Scene& scene, const Yields& yields,
               const std::vector<std::string>& methods, bool with_kinds, Sums& sums) {
  std::vector<std::string> cells{key.second};
  if (with_kinds) cells.push_back(key.first);
  const auto known =
      std::find_if(scene.begin(), scene.end(), [](const auto& entry) { return has_truth(*entry.second); });
  for (const Group& group : groups) {
    cells.push_back(known == scene.end()
                        ? "no truth"
                        : std::to_string((there_is_in(*known->second->score).*group.tally)->n));
    for (const std::string& method : methods) {
      const auto row = scene.find(method);
      const bool is_scored = row != scene.end() && has_truth(*row->second);
      cells.emplace_back(row == scene.end() ? "not run" : "no truth");
      if (!is_scored) continue;
      const auto parts = yields.find(method);  // none: it failed everywhere
      const std::optional<Tally> found =
          found_in(*row->second->score,
                   parts == yields.end() ? PredictedParts{true, true, true, true} : parts->second).*
          group.tally;
      cells.back() = found ? std::to_string(found->hit) : "n/a";
      if (!found) continue;
      sums[{group.name, method}].hit += found->hit;
      sums[{group.name, method}].n += found->n;
    }
  }
  table.rows.push_back(std::move(cells));
}

void add_totals(ReportTable& table, const std::vector<std::string>& methods, bool with_kinds, Sums& sums) {
  std::vector<std::string> cells{"all"};
  if (with_kinds) cells.emplace_back();
  for (const Group& group : groups) {
    int there = 0;
    for (const std::string& method : methods) there = std::max(there, sums[{group.name, method}].n);
    cells.push_back(std::to_string(there));
    for (const std::string& method : methods) {
      const Tally& sum = sums[{group.name, method}];
      cells.push_back(sum.n == 0 ? "n/a" : fmt::format("{:.1f} %", 100.0 * sum.hit / sum.n));
    }
  }
  table.rows.push_back(std::move(cells));
}

}  // namespace

ReportTable table2_of_paper(const RunRecord& run, const std::string& dataset) {
  const std::vector<std::string>& methods = run.manifest.methods;
  const std::map<SceneKey, Scene> scenes = scenes_of(run, dataset);
  const bool with_kinds =
      std::any_of(scenes.begin(), scenes.end(), [](const auto& scene) { return !scene.first.first.empty(); });
  ReportTable table;
  table.caption = fmt::format("Graspable objects, surfaces and edges on {}: there, and found", dataset);
  table.header = {"frame"};
  table.full_rows_file = "metrics/frames.csv";
  if (with_kinds) table.header.emplace_back("kind");
  for (const Group& group : groups) {
    table.header.emplace_back(group.name);
    table.header.insert(table.header.end(), methods.begin(), methods.end());
  }
  const bool any_truth = std::any_of(scenes.begin(), scenes.end(), [](const auto& scene) {
    return std::any_of(scene.second.begin(), scene.second.end(),
                       [](const auto& entry) { return has_truth(*entry.second); });
  });
  if (!any_truth) return table;
  Sums sums;
  const Yields yields = yields_of(scenes);
  for (const auto& [key, scene] : scenes) add_scene(table, key, scene, yields, methods, with_kinds, sums);
  add_totals(table, methods, with_kinds, sums);
  table.notes = {
      "Objects count with a pose and a grasp, or with a pose where a method yields no grasps. Of a method "
      "without regions, objects and surfaces count by a grasp between two of their graspable edges."};
  return table;
}

}  // namespace facet
