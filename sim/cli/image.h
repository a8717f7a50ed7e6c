// The image of a sketch that the user named.
#pragma once

#include "hal/board/board_spec.h"
#include "sim/cli/names.h"
#include "sim/cli/progress.h"
#include "sim/client/messages.h"
#include "sim/sketch/sketch.h"

namespace robosim::cli {

/// The board a robot carries.
const BoardSpec& board_of(const client::RobotInfo& robot);

/// A finished .elf as it is; anything else compiled, the compiler's warnings going to standard error if they
/// are wanted. Throws InputError and ToolMissing.
sketch::Image image_of(const SketchChoice& sketch, const sketch::Request& request, Progress& progress,
                       bool warnings = true);

}  // namespace robosim::cli
