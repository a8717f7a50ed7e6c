// For which chip avr-gcc has built a program.
#pragma once

#include <string>

#include "sim/elf/elf_file.h"

namespace robosim {

/// As -mmcu has it: "atmega328p". Empty where the file does not say: it is not of avr-libc 2, whose start-up
/// code of each chip brings a note of it.
std::string avr_device(const ElfFile& elf);

}  // namespace robosim
