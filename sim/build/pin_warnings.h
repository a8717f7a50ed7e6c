// Pins that a board does not have, or that cannot do what a sketch asks of them: nothing tells so on the
// chip.
#pragma once

#include <string>

#include "hal/board/board_spec.h"

namespace robosim::build {

/// Warnings as a compiler writes them, a line each, on calls such as pinMode(50, OUTPUT) in the sketch's own
/// preprocessed lines (own_lines in prototypes.h). Looked at are numbers, names of pins, and variables that
/// are set once, to a number.
std::string pin_warnings(const std::string& own_lines, const BoardSpec& board);

/// A warning of the first Serial.print() of a sketch in which nobody begins Serial; `all` is what its .ino
/// files are preprocessed to, with all headers. Not for boards whose Serial is a USB. For sketches without
/// other sources and libraries, which may begin it.
std::string serial_warning(const std::string& own_lines, const std::string& all, const BoardSpec& board);

}  // namespace robosim::build
