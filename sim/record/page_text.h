// The page of sim/page in one piece, without a recording.
#pragma once

#include <string_view>

namespace robosim::record {

/// Defined in a source file that CMake makes of sim/page (toolchain/cmake/bundle_page.cmake).
std::string_view page_text();

}  // namespace robosim::record
