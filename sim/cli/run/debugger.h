// `robosim run --gdb PORT`: what the user types in another terminal.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace robosim::cli {

/// Throws InputError where debugging is not possible.
void check_debugger(int port, const std::string& target);

/// "avr-gdb -d /…/Blink /…/Blink.elf -ex 'target remote :3333'" for a shell, with the debugger that is
/// installed. `sources`: the sketch's folder, which the image does not name; empty = not known.
std::string debugger_command(const std::filesystem::path& elf, const std::filesystem::path& sources,
                             const std::string& target, int port);

}  // namespace robosim::cli
