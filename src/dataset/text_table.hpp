#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace facet {

/// The words of one line.
using TextLine = std::vector<std::string>;

/// The lines of a text, cut at blanks; empty lines and those that begin with # are left out. Takes any bytes.
std::vector<TextLine> text_lines(std::string_view text);

/// The same of a file; throws Error{data} where it is missing, empty or unreadable.
std::vector<TextLine> read_text_lines(const std::filesystem::path& path);

/// The finite number that the whole text is, nothing where it is none.
std::optional<double> finite_number(std::string_view text);

}  // namespace facet
