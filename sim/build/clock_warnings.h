// Warns if a variable with too few bits holds a time of millis() or micros(). Such a sketch works until the
// time since power-on no longer fits the variable:
//
//   uint16_t since = 0;
//   if (millis() - since >= 5000) since = millis();   // after 65.536 s always true: `since` is too small
//
// The check does not know the sketch's own templates, macros and types. It ignores a name whose declarations
// have different types. It also ignores a time that it cannot trace to a variable.
#pragma once

#include <string>
#include <vector>

#include "hal/board/board_spec.h"

namespace robosim::build {

/// Returns warnings in a compiler's format, one per line. `preprocessed` is the sketch's source with all
/// headers; `own_files` names the sketch's files in it.
std::string clock_warnings(const std::string& preprocessed, const std::vector<std::string>& own_files,
                           const BoardSpec& board);

}  // namespace robosim::build
