// Warns about conditions in which one value is compared twice, as after a copied line:
//
//   if (s[0] == 0 && s[4] == 1 && s[4] == 0)    // never true
//   if (s[0] == 0 && s[4] == 0 && s[4] == 0)    // is s[3] meant?
//   if (mode != 1 || mode != 2)                 // always true
//
// gcc reports only conditions with two operands and without calls (-Wlogical-op). This check reports others.
#pragma once

#include <string>

namespace robosim::build {

/// Returns warnings in a compiler's format, one per line. `own_lines` are the sketch's preprocessed lines
/// (prototypes.h). Checks operands of && and || that compare something with a constant: a variable, an
/// element, or a result of digitalRead() or analogRead().
std::string condition_warnings(const std::string& own_lines);

}  // namespace robosim::build
