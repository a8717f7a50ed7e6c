// `robosim build`
#pragma once

#include <string>

#include "hal/board/board_spec.h"
#include "sim/cli/arguments.h"
#include "sim/sketch/sketch.h"

namespace robosim::cli {

/// What `robosim build` says of a finished image: sizes, libraries, compiler, and where it is.
std::string size_report(const std::string& sketch, const sketch::Image& image, const BoardSpec& board);

/// Compiles for the board of the robot that `robosim run` would take. The compiler's warnings go to standard
/// error, the sizes to standard output. Throws InputError (sketch::CompileError) or ToolMissing.
int build_command(const BuildArguments& arguments);

}  // namespace robosim::cli
