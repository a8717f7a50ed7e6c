// Warns about pins that a board does not have, or that lack a required function, such as PWM. The chip itself
// does not report these mistakes.
#pragma once

#include <string>

#include "hal/board/board_spec.h"

namespace robosim::build {

/// Returns warnings in a compiler's format, one per line, on calls such as pinMode(50, OUTPUT). `own_lines`
/// are the sketch's preprocessed lines (prototypes.h). Checks numbers, names of pins, and variables that are
/// set exactly once, to a number. Also warns about attachInterrupt() for pins without an external interrupt.
std::string pin_warnings(const std::string& own_lines, const BoardSpec& board);

/// Returns a warning for the first Serial.print() of a sketch that never calls Serial.begin(). `all` is the
/// sketch's preprocessed .ino files, with all headers. Boards whose Serial is a USB port need no warning.
/// Call this only for sketches without other sources or libraries, because these may call Serial.begin().
std::string serial_warning(const std::string& own_lines, const std::string& all, const BoardSpec& board);

/// Returns a warning if the sketch waits without a limit for a computer at the board's own USB port. A robot
/// that drives without a cable then never starts. Returns an empty text for boards without such a port.
std::string usb_warning(const std::string& own_lines, const BoardSpec& board);

/// Returns the names of the pins with an external interrupt.
std::string interrupt_pins(const BoardSpec& board);

}  // namespace robosim::build
