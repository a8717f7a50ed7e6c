// Functions that hide others where several sources are compiled as one file, as all presets but dev do: an
// anonymous one of one source, and one that a header declares and the next source means.
#pragma once

#include <string>
#include <vector>

#include "tests/unit/structure/include_table.h"

namespace robosim::structure {

/// Returns a message for each function in an anonymous namespace of a .cpp file that may hide another. A
/// header declares a function of its name, and another .cpp file of the library calls that: the compiler may
/// choose either without a warning. A library is a folder of the first two levels, `sim/grid`.
std::vector<std::string> hidden_functions(const Files& files);

}  // namespace robosim::structure
