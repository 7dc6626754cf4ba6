#include <cctype>
#include <fmt/format.h>
#include <openssl/evp.h>

#include "core/error.hpp"
#include "file/file_bytes.hpp"
#include "report/document.hpp"
#include "report/markup.hpp"
#include "report/page_style.hpp"

namespace facet {
namespace {

std::string base64(const std::vector<std::uint8_t>& bytes) {
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');  // EVP_EncodeBlock ends with a zero
  const int length = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()), bytes.data(),
                                     static_cast<int>(bytes.size()));
  text.resize(static_cast<std::size_t>(length));
  return text;
}

/// A relative path as a link: what is not plain is percent-encoded, '%' too.
std::string url_path(std::string_view path) {
  std::string url;
  for (const char c : path) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) ||
                       std::string_view("/._-").find(c) != std::string_view::npos;
    url += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return url;
}

/// Tables of names and sentences are left-aligned and may wrap; tables of numbers are not.
bool holds_words(const ReportTable& table) {
  return table.header.back() == "reason" || table.header.back() == "value" ||
         table.header.back() == "definition";
}

/// Columns of other data than ours stand back, verdicts stand out.
std::string cell_class(const std::string& column, const std::string& text) {
  if (text.starts_with("  ")) return "part";
  if (column.find("other data") != std::string::npos || column.ends_with('*')) return "other";
  if (text == "holds") return "good";
  return text == "does not" ? "bad" : "";
}

std::string cell(const char* tag, const std::string& column, const std::string& text) {
  const std::string kind = cell_class(column, text);
  return fmt::format("<{0}{1}>{2}</{0}>", tag, kind.empty() ? "" : " class=" + kind,
                     escaped_markup(kind == "part" ? text.substr(2) : text));
}

std::string table_html(const ReportTable& table) {
  constexpr std::size_t long_rows = 30;     // more than these scroll under their header
  constexpr std::size_t many_columns = 10;  // more than these stand closer together
  std::string text;
  if (!table.caption.empty()) text += fmt::format("<p class=caption>{}</p>", escaped_markup(table.caption));
  text += fmt::format("<div class=\"scroll{}{}\"><table{}>", table.rows.size() > long_rows ? " long" : "",
                      table.header.size() > many_columns ? " dense" : "",
                      holds_words(table) ? " class=words" : "");
  text += "<thead><tr>";
  for (const std::string& name : table.header) text += cell("th", name, name);
  text += "</tr></thead><tbody>\n";
  for (const auto& row : table.rows) {
    text += "<tr>";
    for (std::size_t c = 0; c < row.size(); ++c) text += cell("td", table.header[c], row[c]);
    text += "</tr>\n";
  }
  text += "</tbody></table></div>\n";
  for (const std::string& note : table.notes)
    text += fmt::format("<p class=note>{}</p>\n", escaped_markup(note));
  return text;
}

std::string figure_html(const ReportPicture& picture, const std::filesystem::path& run_directory) {
  const std::filesystem::path file = run_directory / picture.file;
  const std::string caption = escaped_markup(picture.caption);
  try {
    const std::string data = base64(read_file_bytes(file));
    return fmt::format(
        "<figure><a href=\"../{2}\"><img alt=\"{0}\" src=\"data:image/png;base64,{1}\"></a>"
        "<figcaption>{0}</figcaption></figure>\n",
        caption, data, url_path(picture.file.generic_string()));
  } catch (const Error&) {  // a run whose pictures were deleted still has its numbers
    return fmt::format("<figure><figcaption>{}: no pictures kept</figcaption></figure>\n", caption);
  }
}

std::string tile_html(const ReportTile& tile) {
  std::string text = fmt::format("<div class=tile><h3>{}</h3><dl>", escaped_markup(tile.title));
  for (const auto& [what, value] : tile.values)
    text += fmt::format("<dt>{}</dt><dd>{}</dd>", escaped_markup(what), escaped_markup(value));
  return text + "</dl></div>\n";
}

std::string chart_html(const ReportChart& chart) {
  std::string text =
      fmt::format("<div class=plot><h3>{}</h3>\n", escaped_markup(chart.title)) + chart_svg(chart);
  for (const std::string& note : chart.notes)
    text += fmt::format("<p class=note>{}</p>\n", escaped_markup(note));
  return text + "</div>\n";
}

/// The items of a kind in a grid of their own; nothing for none.
template <class Items, class Render>
std::string grid(const char* name, const Items& items, const Render& render) {
  if (items.empty()) return {};
  std::string text = fmt::format("<div class={}>\n", name);
  for (const auto& item : items) text += render(item);
  return text + "</div>\n";
}

std::string section_html(const ReportSection& section, std::size_t number,
                         const std::filesystem::path& run_directory) {
  const std::string title = fmt::format("<h2 id=s{}>{}</h2>", number, escaped_markup(section.title));
  std::string text = section.folded ? "<details><summary>" + title + "</summary>\n" : title + '\n';
  for (const std::string& paragraph : section.paragraphs)
    text += fmt::format("<p>{}</p>\n", escaped_markup(paragraph));
  text += grid("tiles", section.tiles, tile_html) + grid("plots", section.charts, chart_html);
  for (const ReportTable& table : section.tables) text += table_html(table);
  text += grid("pictures", section.pictures,
               [&](const ReportPicture& picture) { return figure_html(picture, run_directory); });
  return section.folded ? text + "</details>\n" : text;
}

}  // namespace

std::string render_html(const Report& report, const std::filesystem::path& run_directory) {
  std::string text = fmt::format(
      "<!doctype html>\n<html lang=en><head><meta charset=utf-8>\n"
      "<meta name=viewport content=\"width=device-width, "
      "initial-scale=1\">\n<title>{0}</title>\n<style>{1}{2}</style>"
      "</head><body>\n<header><h1>{0}</h1>\n<nav>",
      escaped_markup(report.title), page_style, chart_style());
  for (std::size_t i = 0; i < report.sections.size(); ++i)
    text += fmt::format("<a href=\"#s{}\">{}</a>", i, escaped_markup(report.sections[i].title));
  text += "</nav></header>\n";
  for (std::size_t i = 0; i < report.sections.size(); ++i)
    text += section_html(report.sections[i], i, run_directory);
  return text + "</body></html>\n";
}

}  // namespace facet
