// Finds functions that hide others if several sources are compiled as one file, as in all presets except
// `dev`. A function in the anonymous namespace of one source may have the name of a header's function. In
// that one file, it then hides the header's function from all later sources.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "tests/unit/structure/include_table.h"

namespace robosim::structure {

/// Returns a message for each function in an anonymous namespace of a .cpp file that may hide another
/// function. The hidden function is declared in a header, and called in another .cpp file of the library. The
/// compiler may choose either function without a warning. Each folder in `libraries` is compiled to a
/// library. A file belongs to the innermost of these folders.
std::vector<std::string> hidden_functions(const Files& files, const std::set<std::string>& libraries);

}  // namespace robosim::structure
