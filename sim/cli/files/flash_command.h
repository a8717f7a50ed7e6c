// `robosim flash`
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/cli/arguments.h"

namespace robosim::cli {

/// avrdude's words, its name first: the board's chip through Arduino's boot loader, as the core's
/// platform.txt has it. `file` is a .hex or an .elf. -D: the boot loader erases each page as it writes it.
std::vector<std::string> avrdude_words(const FlashArguments& arguments, const BoardSpec& board,
                                       const std::filesystem::path& file);

/// Builds the sketch as `robosim build --target avr` does, says so as that does, and writes the .hex of this
/// very image to the board, or a finished .elf as it is; avrdude's output passes through. With --dry-run
/// nothing is written, and avrdude need not be there. Gives the exit status: 1 if the image is over the
/// robot's budget or avrdude fails. Throws InputError (build::CompileError also for what does not fit the
/// chip) or ToolMissing.
int flash_command(const FlashArguments& arguments);

}  // namespace robosim::cli
