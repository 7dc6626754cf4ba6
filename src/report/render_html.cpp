#include <cctype>
#include <fmt/format.h>
#include <openssl/evp.h>

#include "core/error.hpp"
#include "file/file_bytes.hpp"
#include "report/document.hpp"

namespace facet {
namespace {

constexpr std::string_view style = R"(
:root { color-scheme: light dark; --line: #8884; --soft: #8881; --link: #2a6fb0; }
* { box-sizing: border-box; }
body { font: 16px/1.5 system-ui, sans-serif; max-width: 72rem; margin: 0 auto; padding: 1rem; }
h1 { font-size: 1.5rem; margin: .5rem 0 1rem; } h2 { font-size: 1.15rem; margin: 2.2rem 0 .6rem; }
.scroll { overflow-x: auto; margin: .6rem 0; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: .92rem; }
caption { text-align: left; font-weight: 600; padding: .4rem 0; }
th, td { padding: .25rem .7rem; border-bottom: 1px solid var(--line); text-align: right; white-space: nowrap; }
th:first-child, td:first-child { text-align: left; } th { background: var(--soft); font-weight: 600; }
th:first-child, td:first-child { position: sticky; left: 0; background: Canvas; }
.words td { text-align: left; white-space: normal; overflow-wrap: anywhere; } .words th { text-align: left; }
td.part { padding-left: 1.8rem; opacity: .75; }
.note { font-size: .86rem; opacity: .8; margin: .2rem 0; max-width: 60rem; }
.pictures { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 30rem), 1fr)); gap: 1rem; }
figure { margin: 0; } figure img { width: 100%; height: auto; border: 1px solid var(--line); border-radius: 4px; }
figcaption { font-size: .85rem; overflow-wrap: anywhere; }
)";

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

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

std::string cell(const std::string& text) {
  if (text.starts_with("  ")) return fmt::format("<td class=part>{}</td>", escaped(text.substr(2)));
  return fmt::format("<td>{}</td>", escaped(text));
}

/// Tables of names and sentences are left-aligned and may wrap; tables of numbers are not.
bool holds_words(const ReportTable& table) {
  return table.header.back() == "reason" || table.header.back() == "value";
}

std::string table_html(const ReportTable& table) {
  std::string text = fmt::format("<div class=scroll><table{}>", holds_words(table) ? " class=words" : "");
  if (!table.caption.empty()) text += fmt::format("<caption>{}</caption>", escaped(table.caption));
  text += "<thead><tr>";
  for (const std::string& name : table.header) text += fmt::format("<th>{}</th>", escaped(name));
  text += "</tr></thead><tbody>\n";
  for (const auto& row : table.rows) {
    text += "<tr>";
    for (const std::string& value : row) text += cell(value);
    text += "</tr>\n";
  }
  text += "</tbody></table></div>\n";
  for (const std::string& note : table.notes) text += fmt::format("<p class=note>{}</p>\n", escaped(note));
  return text;
}

std::string figure_html(const ReportPicture& picture, const std::filesystem::path& run_directory) {
  const std::filesystem::path file = run_directory / picture.file;
  const std::string caption = escaped(picture.caption);
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

}  // namespace

std::string render_html(const Report& report, const std::filesystem::path& run_directory) {
  std::string text = fmt::format(
      "<!doctype html>\n<html lang=en><head><meta charset=utf-8>\n"
      "<meta name=viewport content=\"width=device-width, "
      "initial-scale=1\">\n<title>{0}</title>\n<style>{1}</style>"
      "</head><body>\n<h1>{0}</h1>\n",
      escaped(report.title), style);
  for (const ReportSection& section : report.sections) {
    text += fmt::format("<h2>{}</h2>\n", escaped(section.title));
    for (const std::string& paragraph : section.paragraphs)
      text += fmt::format("<p>{}</p>\n", escaped(paragraph));
    for (const ReportTable& table : section.tables) text += table_html(table);
    if (section.pictures.empty()) continue;
    text += "<div class=pictures>\n";
    for (const ReportPicture& picture : section.pictures) text += figure_html(picture, run_directory);
    text += "</div>\n";
  }
  return text + "</body></html>\n";
}

}  // namespace facet
