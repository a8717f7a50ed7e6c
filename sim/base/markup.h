// Escapes text for XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace robosim {

/// Returns a text for use between tags and in attributes in double quotes: &, <, >, " and line ends as
/// references. Characters that XML 1.0 cannot hold (control characters except the tab) become U+FFFD.
std::string markup_text(std::string_view text);

}  // namespace robosim
