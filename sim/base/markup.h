// Text inside of XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace robosim {

/// Text as it may stand between tags and in attributes in double quotes: &, <, >, " and line ends as
/// references; what XML 1.0 cannot hold (control characters but the tab) becomes U+FFFD.
std::string markup_text(std::string_view text);

}  // namespace robosim
