// `robosim build`
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

/// What `robosim build` says of a finished image: sizes, for a chip as Arduino prints them; limits that the
/// firmware states; libraries; and where the `files` are.
std::string size_report(const build::Image& image, const std::string& target, const BoardSpec& board,
                        const std::vector<std::filesystem::path>& files);

/// Each way in which an image for a chip takes more than the robot's budget allows, as a sentence.
std::vector<std::string> over_budget(const build::Image& image, const wire::RobotInfo& robot);

/// An image, and what it was made for.
struct Built {
  build::Image image;
  const BoardSpec& board;
  wire::RobotInfo robot;
};

/// Whether another board may take the place of the robot's own, where that has no chip of the target.
enum class Boards { own, fitting };

/// Compiles for the board of the robot that `robosim run` would take. The compiler's warnings go to standard
/// error. Throws InputError or ToolMissing.
Built build_sketch(const BuildArguments& arguments, Boards boards);

/// Reports on standard error how an image for a chip exceeds the robot's budget; `failed` if it does. Throws
/// build::CompileError for what does not fit the chip at all.
ExitStatus check_size(const Built& built);

/// Compiles for the board of the robot that `robosim run` would take. The compiler's warnings go to standard
/// error, the report to standard output. Gives the exit status: 1 if it is over the budget. Throws InputError
/// (build::CompileError also for what does not fit the chip) or ToolMissing.
int build_command(const BuildArguments& arguments);

}  // namespace robosim::cli
