// `robosim run --gdb PORT`: prints the command that starts the debugger in another terminal.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace robosim::cli {

/// Throws InputError if the user requests a debugger for the target `host`.
void check_debugger(int port, const std::string& target);

/// Returns "avr-gdb -d /…/Blink /…/Blink.elf -ex 'target remote :3333'" for a shell, with the installed
/// debugger. `sources` is the sketch's folder, since `elf` does not contain its path; empty = unknown.
std::string debugger_command(const std::filesystem::path& elf, const std::filesystem::path& sources,
                             const std::string& target, int port);

}  // namespace robosim::cli
