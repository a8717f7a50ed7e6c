// Escapes text for XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace robosim {

/// Returns `text` in a form that is valid between tags, and in attributes in double quotes. The characters &,
/// <, >, " and line feeds become references. Other control characters except the tab, invalid UTF-8, and
/// characters that XML 1.0 does not allow become U+FFFD.
std::string markup_text(std::string_view text);

}  // namespace robosim
