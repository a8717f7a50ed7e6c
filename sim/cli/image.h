// What a sketch that the user named runs as and on: its image, and the robot with a board for it.
#pragma once

#include <functional>
#include <string>

#include "hal/board/board_spec.h"
#include "sim/cli/names.h"
#include "sim/cli/progress.h"
#include "sim/client/messages.h"
#include "sim/sketch/sketch.h"

namespace robosim::cli {

/// The board a robot carries.
const BoardSpec& board_of(const client::RobotInfo& robot);

/// The target that is this board's chip.
std::string chip_target_of(const BoardSpec& board);

/// A robot that a sketch for this target can drive.
struct Carrier {
  Choice robot;
  client::RobotInfo info;
  std::string announcement;  ///< that another board takes the place of its own; empty = none does
};
/// Throws InputError where no board of the target has all pins that the robot uses.
Carrier fit_to_target(const Choice& robot, const std::string& target,
                      const std::function<client::RobotInfo(const std::string&)>& describe);

/// A finished .elf as it is; anything else compiled, the compiler's warnings going to standard error if they
/// are wanted. Throws InputError and ToolMissing.
sketch::Image image_of(const SketchChoice& sketch, const sketch::Request& request, Progress& progress,
                       bool warnings = true);

}  // namespace robosim::cli
