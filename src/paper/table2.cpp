#include <fmt/format.h>

#include "paper/paper_numbers.hpp"
#include "paper/reproduction.hpp"
#include "report/run_report.hpp"

namespace facet {
namespace {

/// The things that Table 2 counts, ours and the paper's.
struct Group {
  const char* name;
  Tally (*ours)(const FrameScore&);
  int PaperScene::*there;
  int PaperScene::*paper;
  int PaperScene::*behal;  ///< of [19]; null where it is not legible by scene
};
constexpr Group groups[]{{"objects", [](const FrameScore& s) { return s.grasps.objects_grasp; },
                          &PaperScene::objects, &PaperScene::objects_found, &PaperScene::objects_19},
                         {"surfaces", [](const FrameScore& s) { return s.grasps.surfaces; },
                          &PaperScene::surfaces, &PaperScene::surfaces_found, nullptr},
                         {"edges", [](const FrameScore& s) { return s.edges.recall_6px.graspable; },
                          &PaperScene::edges, &PaperScene::edges_found, &PaperScene::edges_19}};

std::string share_text(int hit, int n) {
  return n == 0 ? "n/a" : fmt::format("{:.2f} %", 100.0 * hit / n);
}

/// Score of our scene number `scene` (from 0) under a method; null where it was not scored.
const FrameScore* score_of(const RunRecord& run, const std::string& method, std::size_t scene) {
  const std::string frame = fmt::format("table2_{:03}", scene);
  for (const FrameRow& row : run.frames)
    if (row.method == method && row.frame == frame && row.score) return &*row.score;
  return nullptr;
}

class Table2 {
 public:
  explicit Table2(const RunRecord& run) : run_(run) {
    table_.caption = "Graspable objects, surfaces and edges: there, and found";
    table_.header = {"scene", "kind"};
    for (const Group& group : groups) {
      table_.header.emplace_back(group.name);
      for (const std::string& method : run.manifest.methods) table_.header.push_back(method);
      table_.header.insert(table_.header.end(), {"paper*", "[19]*"});
    }
    for (std::size_t i = 0; i < paper_table2.size(); ++i) add_scene(i);
    add_totals();
    table_.notes = {
        "Our scenes are built to hold exactly the objects, surfaces and edges of the paper's rows.",
        "* other data: the paper's and [19]'s counts on eight frames of OSD whose truth was never published.",
        "An object counts with a pose and a force-closure grasp on a surface found at IoU 0.5; an edge with "
        "kind "
        "and graspable label right along 70 % of its length within 6 px."};
  }
  ReportTable take() { return std::move(table_); }
  bool is_measured() const { return measured_; }

 private:
  struct Sum {
    int hit = 0, n = 0;
  };

  void add_scene(std::size_t scene) {
    const PaperScene& paper = paper_table2[scene];
    std::vector<std::string> cells{std::to_string(scene + 1), std::string(paper.kind)};
    for (const Group& group : groups) {
      const FrameScore* first = score_of(run_, run_.manifest.methods.front(), scene);
      cells.push_back(first == nullptr ? "no truth" : std::to_string(group.ours(*first).n));
      for (const std::string& method : run_.manifest.methods) cells.push_back(found(group, method, scene));
      cells.push_back(std::to_string(paper.*group.paper));
      cells.push_back(group.behal == nullptr ? "-" : std::to_string(paper.*group.behal));
    }
    table_.rows.push_back(std::move(cells));
  }

  std::string found(const Group& group, const std::string& method, std::size_t scene) {
    const FrameScore* score = score_of(run_, method, scene);
    measured_ = measured_ && score != nullptr;
    if (score == nullptr) return "n/a";
    const Tally tally = group.ours(*score);
    Sum& sum = sums_[{group.name, method}];
    sum.hit += tally.hit;
    sum.n += tally.n;
    return std::to_string(tally.hit);
  }

  void add_totals() {
    std::vector<std::string> cells{"all", ""};
    for (const Group& group : groups) {
      Sum paper, behal;
      for (const PaperScene& scene : paper_table2) {
        paper.n += scene.*group.there;
        paper.hit += scene.*group.paper;
        behal.hit += group.behal == nullptr ? 0 : scene.*group.behal;
      }
      if (group.behal == nullptr) behal.hit = paper_surfaces_19;
      cells.push_back(std::to_string(sums_[{group.name, run_.manifest.methods.front()}].n));
      for (const std::string& method : run_.manifest.methods) {
        const Sum& sum = sums_[{group.name, method}];
        cells.push_back(share_text(sum.hit, sum.n));
      }
      cells.push_back(share_text(paper.hit, paper.n));
      cells.push_back(share_text(behal.hit, paper.n));
    }
    table_.rows.push_back(std::move(cells));
  }

  const RunRecord& run_;
  ReportTable table_;
  std::map<std::pair<std::string, std::string>, Sum> sums_;
  bool measured_ = true;
};

}  // namespace

Reproduced reproduce_table2(Reproduction& r) {
  const RunRecord& run = r.run("table2");
  Table2 table(run);
  Reproduced result;
  result.section.title = "Table 2";
  result.is_measured = table.is_measured();
  result.exact = {table.take()};
  const ReportSection detection = detection_section(run);
  if (!detection.tables.empty()) result.section.tables.push_back(detection.tables.front());
  result.section.tables.insert(result.section.tables.begin(), result.exact.front());
  result.latex = latex_table(result.exact.front());
  return result;
}

Reproduced reproduce_table3(Reproduction& r) {
  Reproduced result;
  result.section.title = "Table 3";
  for (const char* name : {"table2", "clutter"}) {
    const RunRecord& run = r.run(name);
    ReportTable table = table3_of_paper(run, name);
    result.is_measured = result.is_measured && !table.rows.empty();
    table.caption = std::string(name) == "table2" ? "Time per stage on the eight scenes of Table 2 [ms]"
                                                  : "Time per stage on scenes of 1 to 20 objects [ms]";
    result.latex += latex_table(table);
    result.section.tables.push_back(std::move(table));
    ReportSection times = timing_section(run);
    for (ReportTable& detail : times.tables) result.section.tables.push_back(std::move(detail));
    for (ReportChart& chart : times.charts) result.section.charts.push_back(std::move(chart));
  }
  return result;
}

Reproduced reproduce_figure12(Reproduction& r) {
  Reproduced result;
  result.section = clutter_section(r.run("clutter"));
  result.section.title = "Figure 12";
  result.section.on_console = true;
  result.is_measured = !result.section.tables.empty();
  for (const ReportTable& table : result.section.tables) {
    ReportTable scores = table;  // without the rows of times
    std::erase_if(scores.rows, [](const auto& row) { return row[0].starts_with("Segmentation time"); });
    result.exact.push_back(std::move(scores));
  }
  return result;
}

}  // namespace facet
