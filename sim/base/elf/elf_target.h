// Finds the target that runs an ELF file.
#pragma once

#include <string>
#include <string_view>

#include "sim/base/error.h"

namespace robosim {

/// Returns "avr" or "stm32" according to the file's header. Throws InputError, which names `file`, if the
/// file is not for an AVR or ARM chip.
std::string target_of_elf(std::string_view content, const std::string& file);

/// Returns the error for a file that is for the target `is` instead of `wanted`.
InputError wrong_target(const std::string& file, std::string_view is, std::string_view wanted);

}  // namespace robosim
