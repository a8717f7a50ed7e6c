// Distinguishes faults of the machine from faults of Robosim and invalid input.
#pragma once

#include <exception>
#include <string>

namespace robosim {

/// Returns a sentence about the resource of the machine that caused the exception: memory, disk space, open
/// files or processes. Returns an empty string for other causes.
std::string system_error_of(const std::exception& thrown);

/// Returns a sentence about a fault of the machine if `output` reports one; otherwise an empty string.
/// The compiler, linker or other tool named `tool` has printed `output`.
std::string system_error_of(const std::string& tool, const std::string& output);

}  // namespace robosim
