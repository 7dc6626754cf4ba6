#include <fmt/format.h>

#include "overlay/depth_panel.hpp"
#include "overlay/edge_panel.hpp"
#include "paper/evaluated_frame.hpp"

namespace facet {
namespace {

/// White lines on black: the union of all edges, which closes every surface.
cv::Mat closed_contours(const EvaluatedFrame& evaluated) {
  const Image<std::uint8_t>& edges = evaluated.frame.prediction.edges;
  const PanelGeometry geometry(edges.size());
  cv::Mat panel(geometry.panel_size, CV_8UC3, cv::Scalar::all(0));
  for (int y = 0; y < panel.rows; ++y)
    for (int x = 0; x < panel.cols; ++x)
      if (edges(std::min(static_cast<int>(x / geometry.scale), edges.width() - 1),
                std::min(static_cast<int>(y / geometry.scale), edges.height() - 1)) != 0)
        panel.at<cv::Vec3b>(y, x) = cv::Vec3b::all(255);
  return panel;
}

std::string percent(const Tally& tally) {
  return tally.n == 0 ? "n/a"
                      : fmt::format("{}/{} {:.1f} %", tally.hit, tally.n, 100.0 * tally.hit / tally.n);
}

/// Scores of the naive approach on the frames of a data set.
struct NaiveRow {
  Tally recall, precision;
};

void add(Tally& sum, const Tally& more) {
  sum.hit += more.hit;
  sum.n += more.n;
}

}  // namespace

Reproduced reproduce_figure3(Reproduction& r) {
  const auto planned = r.plan("figures");
  const EvaluatedFrame frame = evaluate(planned, "scenes", 0, "default");
  const cv::Mat picture = panel_grid(
      {{color_panel(frame, "(a) Scene"), with_title(draw_depth(frame.frame.frame), "(b) Depth, z = f(x, y)"),
        with_title(draw_edges(frame.frame.frame, frame.frame.prediction), "(c) DD red; CD green, blue")},
       {with_title(closed_contours(frame), "(d) Closed contours"),
        surfaces_panel(frame, "(e) " + frame.caption("found"))}});
  Reproduced result;
  result.section.title = "Figure 3";
  result.section.paragraphs = {
      "The steps that isolate surfaces: (a) the scene, (b) its depth, (c) depth discontinuities (red) and "
      "creases "
      "(convex green, concave blue), (d) their union, (e) what lies between."};
  result.section.pictures = {r.save_picture("figure3", picture, "Figure 3: the steps on a built-in scene")};
  return result;
}

Reproduced reproduce_figure4(Reproduction& r) {
  const auto planned = r.plan("figures");
  Reproduced result;
  result.section.title = "Figure 4";
  ReportTable table;
  table.caption = "Figure 4: the naive approach without noise and with it";
  table.header = {"data", "scenes", "surfaces found", "precision", "the paper says", "verdict"};
  std::vector<std::vector<cv::Mat>> rows;
  constexpr double sufficient = 0.95;
  for (const auto& [dataset, name, claim] :
       {std::tuple{"exact", "built-in scenes, exact depth", "fully sufficient"},
        std::tuple{"scenes", "the same scenes, Kinect v1", "fails"}}) {
    NaiveRow sum;
    constexpr std::size_t scenes = 5;
    for (std::size_t i = 0; i < scenes; ++i) {
      const EvaluatedFrame frame = evaluate(planned, dataset, i, "naive");
      add(sum.recall, frame.score->surfaces_50.recall());
      add(sum.precision, frame.score->surfaces_50.precision());
      if (i > 0) continue;
      rows.push_back({color_panel(frame, name), with_title(draw_depth(frame.frame.frame), "Depth"),
                      surfaces_panel(frame, frame.caption("naive"))});
    }
    const bool suffices = sum.recall.hit >= sufficient * sum.recall.n;
    const bool says_suffices = std::string_view(claim) == "fully sufficient";
    table.rows.push_back({name, std::to_string(scenes), percent(sum.recall), percent(sum.precision), claim,
                          suffices == says_suffices ? "holds" : "does not"});
  }
  table.notes = {
      "Sufficient: 95 % of the surfaces found at IoU 0.5. Every robustification step is switched off."};
  if (r.has_data("osd")) {
    const EvaluatedFrame frame = evaluate(r.plan("figures_osd"), "osd", 0, "naive");
    rows.push_back({color_panel(frame, "OSD"), with_title(draw_depth(frame.frame.frame), "Depth"),
                    surfaces_panel(frame, frame.caption("naive"))});
  }
  result.section.pictures = {
      r.save_picture("figure4", panel_grid(rows), "Figure 4: naive segmentation, exact and real depth")};
  result.section.tables = result.exact = {std::move(table)};
  return result;
}

Reproduced reproduce_figure5(Reproduction& r) {
  const auto planned = r.plan("figures");
  Reproduced result;
  result.section.title = "Figure 5";
  ReportTable table;
  table.caption = "Figure 5: each step added to those before";
  table.header = {"frame"};
  constexpr std::array<std::pair<const char*, const char*>, 4> steps{{{"naive", "(b) none"},
                                                                      {"wiener", "(c) Wiener"},
                                                                      {"sobel", "(d) + Sobel"},
                                                                      {"smoothing", "(e) + smoothing"}}};
  for (const auto& [method, title] : steps) table.header.emplace_back(title);
  std::array<Tally, steps.size()> sums{};
  std::vector<std::vector<cv::Mat>> rows;
  for (std::size_t i = 0; i < 5; ++i) {
    std::vector<std::string> cells;
    std::vector<cv::Mat> row;
    for (std::size_t s = 0; s < steps.size(); ++s) {
      const EvaluatedFrame frame = evaluate(planned, "scenes", i, steps[s].first);
      if (s == 0) row.push_back(color_panel(frame, "(a) " + frame.frame.frame.id));
      if (s == 0) cells.push_back(frame.frame.frame.id);
      const Tally recall = frame.score->surfaces_50.recall();
      add(sums[s], recall);
      cells.push_back(fmt::format("{}, {} false", percent(recall), frame.score->surfaces_50.wrong));
      row.push_back(surfaces_panel(frame, fmt::format("{}: {}/{}", steps[s].second, recall.hit, recall.n)));
    }
    table.rows.push_back(std::move(cells));
    rows.push_back(std::move(row));
  }
  table.rows.push_back({"all"});
  for (const Tally& sum : sums) table.rows.back().push_back(percent(sum));
  table.notes = {
      "Surfaces found at IoU 0.5, and false regions. Smoothing: the paper's morphology, pruning, filling, "
      "relocated edges, contours of the edge map and validation, that is the paper's mode."};
  result.section.pictures = {r.save_picture("figure5", panel_grid(rows),
                                            "Figure 5: the robustification steps, one frame per row", 2000)};
  result.section.tables = result.exact = {std::move(table)};
  return result;
}

}  // namespace facet
