#include <array>
#include <fmt/format.h>

#include "report/document.hpp"

namespace facet {
namespace {

struct Replacement {
  std::string_view text, latex;
};
/// What LaTeX gives a meaning, and the characters beyond ASCII that reports use.
constexpr std::array<Replacement, 15> replacements{{{"\\", "\\textbackslash{}"},
                                                    {"%", "\\%"},
                                                    {"&", "\\&"},
                                                    {"_", "\\_"},
                                                    {"#", "\\#"},
                                                    {"$", "\\$"},
                                                    {"{", "\\{"},
                                                    {"}", "\\}"},
                                                    {"~", "\\textasciitilde{}"},
                                                    {"^", "\\textasciicircum{}"},
                                                    {"<", "$<$"},
                                                    {">", "$>$"},
                                                    {"[", "{[}"},
                                                    {"]", "{]}"},
                                                    {"±", "$\\pm$"}}};

std::string latex_text(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    std::size_t taken = 0;
    for (const Replacement& r : replacements)
      if (text.starts_with(r.text)) {
        out += r.latex;
        taken = r.text.size();
      }
    if (taken == 0) {  // any other character outside ASCII would stop pdflatex
      const auto byte = static_cast<unsigned char>(text.front());
      out += byte < 0x80 ? std::string(1, text.front()) : byte >= 0xC0 ? "?" : "";
      taken = 1;
    }
    text.remove_prefix(taken);
  }
  return out;
}

std::string latex_row(const std::vector<std::string>& cells) {
  std::string row;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const bool part = cells[i].starts_with("  ");
    row += (i > 0 ? " & " : "") + std::string(part ? "\\quad " : "") +
           latex_text(part ? std::string_view(cells[i]).substr(2) : cells[i]);
  }
  return row + " \\\\\n";
}

}  // namespace

std::string latex_table(const ReportTable& table) {
  std::string text = fmt::format(
      "\\begin{{table}}[htbp]\n\\centering\n\\caption{{{}}}\n\\resizebox{{\\ifdim"
      "\\width>\\linewidth\\linewidth\\else\\width\\fi}}{{!}}{{%\n",
      latex_text(table.caption));
  text += fmt::format("\\begin{{tabular}}{{l{}}}\n\\hline\n", std::string(table.header.size() - 1, 'r'));
  text += latex_row(table.header) + "\\hline\n";
  for (const auto& row : table.rows) text += latex_row(row);
  text += "\\hline\n\\end{tabular}}\n";
  for (const std::string& note : table.notes)
    text += fmt::format("\n\\smallskip{{\\footnotesize {}\\par}}\n", latex_text(note));
  return text + "\\end{table}\n";
}

}  // namespace facet
