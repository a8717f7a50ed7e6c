// `robosim flash`: builds a sketch and writes it to a board.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/cli/arguments.h"

namespace robosim::cli {

/// Returns the words of avrdude's command line. The command writes `file` (.hex or .elf) through Arduino's
/// boot loader, with the options of the Arduino core's platform.txt. The option -D prevents an erase of the
/// whole chip. No such erase is needed, because the boot loader erases each page before it writes the page.
std::vector<std::string> avrdude_words(const FlashArguments& arguments, const BoardSpec& board,
                                       const std::filesystem::path& file);

/// Builds the sketch and reports like `robosim build --target avr`. Writes the .hex of this image to the
/// board; a finished .elf is written unchanged. avrdude's output passes through. With --dry-run, nothing is
/// written, and avrdude need not be installed. Returns the exit status: 1 if the image exceeds the robot's
/// budget or avrdude fails. Throws InputError (build::CompileError also for an image that does not fit the
/// chip) or ToolMissing.
int flash_command(const FlashArguments& arguments);

}  // namespace robosim::cli
