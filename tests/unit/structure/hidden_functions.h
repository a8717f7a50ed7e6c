// Functions that hide others where several sources are compiled as one file, as all presets but dev do: an
// anonymous one of one source, and one that a header declares and the next source means.
#pragma once

#include <string>
#include <vector>

#include "tests/unit/structure/include_table.h"

namespace robosim::structure {

/// A sentence for each function that a .cpp file keeps in an anonymous namespace, if another .cpp file of its
/// library calls one of the same name that a header declares: the compiler may choose either, and says
/// nothing. A library is a folder of the first two levels, `sim/grid`.
std::vector<std::string> hidden_functions(const Files& files);

}  // namespace robosim::structure
