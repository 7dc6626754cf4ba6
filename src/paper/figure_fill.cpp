#include <algorithm>
#include <fmt/format.h>

#include "cpu/tuned/fill_missing.hpp"
#include "overlay/depth_panel.hpp"
#include "overlay/panel.hpp"
#include "paper/evaluated_frame.hpp"

namespace facet {
namespace {

/// The frame with its holes filled by so many passes.
Frame filled(const Frame& frame, FillParams params, int passes) {
  Frame result = frame;
  const Size size = frame.depth_m.size();
  Image<std::uint8_t> made_up(size), open(size), rim(size);
  Image<float> proposal_m(size);
  CpuExecutor executor;
  params.max_passes = passes;
  fill_missing(executor, params, result.depth_m.view(), made_up.view(),
               {open.view(), rim.view(), proposal_m.view()});
  return result;
}

double missing_share(const Frame& frame) {
  std::int64_t missing = 0;
  for (int y = 0; y < frame.depth_m.height(); ++y)
    for (int x = 0; x < frame.depth_m.width(); ++x) missing += !(frame.depth_m(x, y) > 0);
  return static_cast<double>(missing) / (1.0 * frame.depth_m.width() * frame.depth_m.height());
}

}  // namespace

Reproduced reproduce_figure6(Reproduction& r) {
  const auto planned = r.plan("figures");
  const auto osd = r.has_data("osd") ? std::optional(r.plan("figures_osd")) : std::nullopt;
  Reproduced result;
  result.section.title = "Figure 6";
  ReportTable table;
  table.caption = "Figure 6: share of pixels without depth after each number of passes [%]";
  table.header = {"method"};
  std::vector<std::vector<cv::Mat>> rows;
  constexpr std::array<int, 5> passes{0, 1, 4, 12, 32};
  for (const int p : passes) table.header.push_back(std::to_string(p));
  const EvaluatedFrame built_in = evaluate(planned, "scenes", 0, "default");
  for (const char* method : {"default", "paper"}) {
    const auto& methods = planned.first.methods;
    const auto spec =
        std::find_if(methods.begin(), methods.end(), [&](const auto& m) { return m.name == method; });
    std::vector<std::string> cells{method};
    for (const int p : passes)
      cells.push_back(
          fmt::format("{:.2f}", 100 * missing_share(filled(built_in.frame.frame, spec->params.fill, p))));
    table.rows.push_back(std::move(cells));
    const Frame shown = osd ? evaluate(*osd, "osd", 0, "naive").frame.frame : built_in.frame.frame;
    std::vector<cv::Mat> row;
    for (const int p : passes) {
      const Frame frame = filled(shown, spec->params.fill, p);
      row.push_back(with_title(draw_depth(frame), fmt::format("{}: {} passes, {:.1f} % missing", method, p,
                                                              100 * missing_share(frame))));
    }
    rows.push_back(std::move(row));
  }
  table.notes = {
      "default: shadows are filled from their far side, holes wider than 40 px stay; paper: from all sides, "
      "any width."};
  result.section.pictures = {
      r.save_picture("figure6", panel_grid(rows),
                     osd ? "Figure 6: filling a frame of OSD" : "Figure 6: filling a built-in frame", 2000)};
  result.section.tables = result.exact = {std::move(table)};
  return result;
}

}  // namespace facet
