// Warns about times of millis() and micros() in variables with too few bits. Such a sketch works until the
// time since power-on no longer fits the variable:
//
//   uint16_t since = 0;
//   if (millis() - since >= 5000) since = millis();   // from 65.536 s on, the difference is always larger
//
// The check knows no templates, macros or types of the sketch's own. It is silent about names that several
// declarations give different types, and about times that it cannot follow.
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
