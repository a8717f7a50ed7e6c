// What a sketch that the user named runs as and on: its image, and the robot with a board for it.
#pragma once

#include <functional>
#include <string>

#include "hal/board/board_spec.h"
#include "sim/build/sketch.h"
#include "sim/launch/names.h"
#include "sim/launch/progress.h"
#include "sim/wire/messages.h"

namespace robosim::launch {

/// The board a robot carries.
const BoardSpec& board_of(const wire::RobotInfo& robot);

/// The target that is this board's chip.
std::string chip_target_of(const BoardSpec& board);

/// A robot that a sketch for this target can drive.
struct Carrier {
  Choice robot;
  wire::RobotInfo info;
  std::string announcement;  ///< that another board takes the place of its own; empty = none does
};
/// Throws InputError where no board of the target has all pins that the robot uses.
Carrier fit_to_target(const Choice& robot, const std::string& target,
                      const std::function<wire::RobotInfo(const std::string&)>& describe);

/// A finished .elf as it is; anything else compiled, the compiler's warnings going to standard error if they
/// are wanted. Throws InputError and ToolMissing.
build::Image image_of(const SketchChoice& sketch, const build::Request& request, Progress& progress,
                      bool warnings = true);

}  // namespace robosim::launch
