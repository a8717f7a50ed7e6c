// Distinguishes faults of the machine from faults of Robosim and invalid input.
#pragma once

#include <exception>
#include <string>

namespace robosim {

/// Returns a sentence about the resource that caused the exception: memory, disk space, open files or
/// processes. Returns an empty string for other causes.
std::string system_error_of(const std::exception& thrown);

/// Returns such a sentence if `output`, printed by the compiler, linker or other tool `tool`, reports such a
/// cause; otherwise an empty string.
std::string system_error_of(const std::string& tool, const std::string& output);

}  // namespace robosim
