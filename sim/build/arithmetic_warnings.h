// Warns about constants of a sketch that lose their fraction, and so are usually not what their author meant:
//
//   float kp = 1 / 4;    // 0, because a quotient of integers has no fraction
//   int kd = 0.35;       // 0, because an int has no fraction
//   delay(0.5);          // 0 ms
#pragma once

#include <string>

namespace robosim::build {

/// Returns warnings in a compiler's format, one per line. `own_lines` are the sketch's preprocessed lines
/// (prototypes.h). Reports
///
///   - quotients of integers, or of integer constants, that are 0 although the dividend is not;
///   - numbers that lose a tenth or more of their value, because an integer variable or delay() gets them.
std::string arithmetic_warnings(const std::string& own_lines);

}  // namespace robosim::build
