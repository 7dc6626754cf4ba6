#include "dataset/text_table.hpp"

#include <charconv>
#include <cmath>

#include "file/file_bytes.hpp"

namespace facet {
namespace {

constexpr std::string_view blanks = " \t\r\v\f,";

TextLine words_of(std::string_view line) {
  TextLine words;
  while (true) {
    const std::size_t begin = line.find_first_not_of(blanks);
    if (begin == std::string_view::npos) return words;
    line.remove_prefix(begin);
    const std::size_t end = std::min(line.find_first_of(blanks), line.size());
    words.emplace_back(line.substr(0, end));
    line.remove_prefix(end);
  }
}

}  // namespace

std::vector<TextLine> text_lines(std::string_view text) {
  std::vector<TextLine> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    TextLine words = words_of(text.substr(0, end));
    if (!words.empty() && words.front().front() != '#') lines.push_back(std::move(words));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::vector<TextLine> read_text_lines(const std::filesystem::path& path) {
  const auto bytes = read_file_bytes(path);
  return text_lines({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

std::optional<double> finite_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace facet
