// Provides the HTML page that replays recordings (sim/view/page), as one text and without a recording.
#pragma once

#include <string_view>

namespace robosim::record {

/// Returns the page. CMake generates the source file with this function from sim/view/page
/// (toolchain/cmake/bundle_page.cmake).
std::string_view page_text();

}  // namespace robosim::record
