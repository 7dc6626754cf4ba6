#pragma once

#include <string>
#include <string_view>

namespace facet {

/// Text as it stands in HTML and SVG, also inside quotes.
std::string escaped_markup(std::string_view text);

}  // namespace facet
