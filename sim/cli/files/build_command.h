// `robosim build`: compiles a sketch and reports its size.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hal/board/board_spec.h"
#include "sim/base/error.h"
#include "sim/build/sketch.h"
#include "sim/cli/arguments.h"
#include "sim/wire/messages.h"

namespace robosim::cli {

/// Returns the report of `robosim build` on a finished image: sizes, declared limits (build::Limit),
/// libraries, and the paths of `files`. Sizes for a chip are in Arduino's format.
std::string size_report(const build::Image& image, const std::string& target, const BoardSpec& board,
                        const std::vector<std::filesystem::path>& files);

/// Returns a sentence for each limit in the robot's [budget] that `image`, built for a chip, exceeds.
std::vector<std::string> over_budget(const build::Image& image, const wire::RobotInfo& robot);

/// An image, the board for which it was built, and the robot.
struct Built {
  build::Image image;
  const BoardSpec& board;
  wire::RobotInfo robot;
};

/// Selects the board if the robot's own board does not suit the target. `own` keeps the robot's board;
/// `fitting` selects a board that suits the target.
enum class Boards { own, fitting };

/// Compiles for the board of the robot that `robosim run` would use. The compiler's warnings go to standard
/// error. Throws InputError or ToolMissing.
Built build_sketch(const BuildArguments& arguments, Boards boards);

/// Checks an image for a chip against the robot's budget. Reports each excess on standard error and returns
/// `failed`. Throws build::CompileError for an image that does not fit the chip at all.
ExitStatus check_size(const Built& built);

/// Compiles for the board of the robot that `robosim run` would use. The compiler's warnings go to standard
/// error, the report to standard output. Returns the exit status: 1 if the image exceeds the budget. Throws
/// InputError (build::CompileError also for an image that does not fit the chip) or ToolMissing.
int build_command(const BuildArguments& arguments);

}  // namespace robosim::cli
