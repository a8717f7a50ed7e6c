// Explains in plain words that two parts of a program define a handler for the same interrupt. The linker
// reports only a "multiple definition of `__vector_5'".
#pragma once

#include <filesystem>
#include <string>

#include "hal/board/board_spec.h"

namespace robosim::build {

/// The chip whose interrupt vectors a program uses, and avr-libc's folder include/avr.
struct Vectors {
  const ChipSpec& chip;
  const std::filesystem::path& avr_libc;
};

/// Returns avr-libc's name of a vector, such as PCINT2_vect, from avr-libc's header for the chip. Returns an
/// empty text if the header has no such name.
std::string vector_name(const Vectors& vectors, int number);

/// Returns a sentence about the first vector that the linker reports as defined twice: its name, its two
/// owners, and what to do. Returns an empty text if there is no such vector. avr-gcc's linker reports no line
/// numbers; this function finds them in `own_lines`, the sketch's preprocessed lines (prototypes.h).
std::string vector_hint(const std::string& messages, const std::string& own_lines, const BoardSpec& board,
                        const Vectors& vectors);

/// Returns warnings in a compiler's format, one per line, about handlers that the AVR core also defines:
/// ISR(INT0_vect) with attachInterrupt(), and ISR(TIMER2_COMPA_vect) with tone(). Such a sketch links
/// for the host, whose core needs no handlers, but not for the chip.
std::string core_handler_warnings(const std::string& own_lines, const BoardSpec& board,
                                  const std::filesystem::path& avr_libc);

}  // namespace robosim::build
