// Provides the HTML page that replays recordings (sim/view/page), as one text and without a recording.
#pragma once

#include <string_view>

namespace robosim::record {

/// Returns the page. CMake generates the definition of this function from the files in sim/view/page
/// (toolchain/cmake/bundle_page.cmake).
std::string_view page_text();

}  // namespace robosim::record
