// Finds the chip for which avr-gcc has built a program.
#pragma once

#include <string>

#include "sim/elf/elf_file.h"

namespace robosim {

/// Returns the name for -mmcu: "atmega328p". Empty if the file lacks it: only avr-libc 2 has a note in the
/// start-up code of each chip.
std::string avr_device(const ElfFile& elf);

}  // namespace robosim
