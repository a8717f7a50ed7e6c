// Finds the chip for which avr-gcc has compiled a program.
#pragma once

#include <string>
#include <string_view>

#include "sim/base/elf/elf_file.h"

namespace robosim {

/// Returns the name for -mmcu: "atmega328p". Returns an empty string if the file lacks the name, which is in
/// a note of avr-libc 2's start-up code.
std::string avr_device(const ElfFile& elf);

/// Returns whether programs for these names of -mmcu are interchangeable: "atmega328" and "atmega328p".
bool is_same_device(std::string_view a, std::string_view b);

}  // namespace robosim
