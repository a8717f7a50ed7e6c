// What is the machine's fault, told from faults of Robosim and of what the user gave.
#pragma once

#include <exception>
#include <string>

namespace robosim {

/// A sentence on what the machine lacks, if that is why this was thrown: memory, room on a disk, open files,
/// processes. Else empty.
std::string fault_of_machine(const std::exception& thrown);

/// The same of what a compiler, linker or other tool has written; `tool` is its name.
std::string fault_of_machine(const std::string& tool, const std::string& output);

}  // namespace robosim
