// Provides the whole page of sim/page as one text, without a recording.
#pragma once

#include <string_view>

namespace robosim::record {

/// Returns the page. Defined in a source file that CMake makes from sim/page
/// (toolchain/cmake/bundle_page.cmake).
std::string_view page_text();

}  // namespace robosim::record
