#include "sim/cli/calibrate/calibrate_command.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/base/file_lock.h"
#include "sim/campaign/calibrate/calibrate.h"
#include "sim/campaign/calibrate/plot.h"
#include "sim/cli/output.h"
#include "sim/launch/names.h"

namespace robosim::cli {
namespace fs = std::filesystem;
namespace {

void refuse_existing(const std::string& file, const char* option) {
  std::error_code error;
  if (!file.empty() && fs::exists(fs::symlink_status(file, error)) && !fs::is_character_file(file, error))
    throw InputError(
        {file}, fmt::format("exists already; nothing was written; remove it, or name another {}", option));
}

}  // namespace

int calibrate_command(const CalibrateArguments& arguments) {
  const bool stock = !launch::is_path(arguments.robot);
  if (arguments.in_place && stock)
    throw InputError(
        fmt::format("--in-place: {} is a stock robot, which is not overwritten; write a file with --out",
                    arguments.robot));
  if (arguments.robot.find('@') != std::string::npos)
    throw InputError(fmt::format(
        "“{}” replaces the robot's board: expected a robot file with the board of the log", arguments.robot));
  refuse_existing(arguments.out, "--out");
  refuse_existing(arguments.plot, "--plot");
  for (const std::string& file : {arguments.out, arguments.plot})
    if (!file.empty()) check_can_be_written(file);
  const calibrate::Task task{arguments.robot, arguments.logs, arguments.stopwatch, arguments.tape_m,
                             arguments.supply_volts};
  const calibrate::Calibration result = calibrate::calibrate(task);
  // Resolves a symbolic link, so that the link's target is overwritten, and not the link.
  const std::string file = arguments.in_place ? fs::canonical(arguments.robot).string() : arguments.out;
  std::string written;
  if (!file.empty()) written = calibrate::calibrated_text(task, result, file);
  if (!arguments.plot.empty()) write_file(arguments.plot, calibrate::plot(result));
  if (!file.empty()) write_file(file, written);
  std::string text = calibrate::report(result);
  for (const std::string& name : {arguments.plot, arguments.in_place ? arguments.robot : file})
    if (!name.empty()) text += name + " is written\n";
  if (file.empty()) text += "no robot file was written; --out FILE or --in-place writes one\n";
  print(text);
  return static_cast<int>(ExitStatus::ok);
}

}  // namespace robosim::cli
