// Tells faults of the machine from faults of Robosim and invalid input.
#pragma once

#include <exception>
#include <string>

namespace robosim {

/// Returns a sentence on what the machine lacks, if that is why this was thrown: memory, disk space, open
/// files, processes. Else returns an empty string.
std::string system_error_of(const std::exception& thrown);

/// Does so for the output of a compiler, linker or other tool of that name.
std::string system_error_of(const std::string& tool, const std::string& output);

}  // namespace robosim
