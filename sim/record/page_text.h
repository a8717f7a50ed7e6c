// Provides the whole page of sim/view/page as one text, without a recording.
#pragma once

#include <string_view>

namespace robosim::record {

/// Returns the page. Defined in a source file that CMake makes from sim/view/page
/// (toolchain/cmake/bundle_page.cmake).
std::string_view page_text();

}  // namespace robosim::record
