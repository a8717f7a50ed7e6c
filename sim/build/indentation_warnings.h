// Warns about a line that looks like a part of an `if`, `else`, `for` or `while`, but follows it:
//
//   if (button)
//     left = 0;
//     right = 0;      // always executed, because the `if` has no braces
//
// gcc's -Wmisleading-indentation cannot do this, because it reads columns from the sketch's file. gcc cannot
// find this file: its input is the preprocessed sketch.
#pragma once

#include <string>

namespace robosim::build {

/// Returns warnings in a compiler's format, one per line. `source` is a sketch's source, with line markers.
/// Reports a line only if it has exactly the leading spaces and tabs of the line before it. The line with the
/// `if` must have fewer of them.
std::string indentation_warnings(const std::string& source);

}  // namespace robosim::build
