#include "sim/cli/calibrate/calibrate_command.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "sim/base/units.h"
#include "sim/calibrate/calibrate.h"
#include "sim/calibrate/plot.h"
#include "sim/cli/options.h"
#include "sim/cli/output.h"
#include "sim/launch/names.h"

namespace robosim::cli {
namespace fs = std::filesystem;
namespace {

double quantity(const char* option, const std::string& text, Dimension dimension, double least, double most,
                const char* allowed) {
  const auto value = parse_quantity(text, dimension);
  if (!value || *value < least || *value > most) refuse_value(option, text, allowed);
  return *value;
}

void refuse_existing(const std::string& file, const char* option) {
  std::error_code error;
  if (!file.empty() && fs::exists(fs::symlink_status(file, error)) && !fs::is_character_file(file, error))
    throw InputError(
        {file}, fmt::format("exists already, so nothing was written; remove it, or name another {}", option));
}

}  // namespace

Command parse_calibrate(const std::vector<std::string>& words) {
  CalibrateArguments calibrate;
  std::string tape, supply;
  Options options("calibrate",
                  "Fits a robot file's figures to logs of the real robot, and says how sure they are.");
  options.positional("ROBOT", calibrate.robot, "the robot file");
  options.positionals("LOG", calibrate.logs, "files that the sketch CalibrationLogger has printed");
  options.text("--tape", tape, "WIDTH", "of the tape that the sensors swept over, as in \"19 mm\"");
  options.text("--supply", supply, "VOLTS", "of the battery meanwhile, as in \"7.4 V\"");
  options.text("--stopwatch", calibrate.stopwatch, "FILE", "drives by stopwatch and tape measure, as TOML");
  options.text("--out", calibrate.out, "FILE", "the robot file with the figures is written there");
  options.flag("--in-place", calibrate.in_place, "the figures are put into the robot file itself");
  options.text("--plot", calibrate.plot, "FILE", "measured against fitted, as .svg");
  if (const auto help = options.parse(words)) return PrintText{*help};
  if (calibrate.robot.empty())
    throw InputError(
        "robosim calibrate needs a robot file and a log, as in robosim calibrate robot.toml log.csv --tape "
        "\"19 mm\"");
  if (calibrate.logs.empty() && calibrate.stopwatch.empty())
    throw InputError("robosim calibrate needs a log, or --stopwatch FILE");
  if (!tape.empty())
    calibrate.tape_m = quantity("--tape", tape, Dimension::length, 0.003, 0.1,
                                "a width from 3 mm to 100 mm, as in \"19 mm\"");
  if (!supply.empty())
    calibrate.supply_volts = quantity("--supply", supply, Dimension::voltage, 1.0, 30.0,
                                      "a voltage from 1 V to 30 V, as in \"7.4 V\"");
  if (!calibrate.out.empty() && calibrate.in_place)
    throw InputError("--out names a new file, --in-place takes the old one; give one of them");
  if (!calibrate.plot.empty() && calibrate.plot == calibrate.out)
    throw InputError(
        fmt::format("--out and --plot both name {}; give them files of their own", calibrate.out));
  if (!calibrate.plot.empty() && !calibrate.plot.ends_with(".svg"))
    refuse_value("--plot", calibrate.plot, "a file that ends in .svg");
  return calibrate;
}

int calibrate_command(const CalibrateArguments& arguments) {
  const bool stock = !launch::is_path(arguments.robot);
  if (arguments.in_place && stock)
    throw InputError(
        fmt::format("{} is a robot of Robosim's own; name a file to write by --out", arguments.robot));
  if (arguments.robot.find('@') != std::string::npos)
    throw InputError(
        fmt::format("“{}” is a robot on another board; calibrate the file of the board that was logged",
                    arguments.robot));
  refuse_existing(arguments.out, "--out");
  refuse_existing(arguments.plot, "--plot");
  const calibrate::Task task{arguments.robot, arguments.logs, arguments.stopwatch, arguments.tape_m,
                             arguments.supply_volts};
  const calibrate::Calibration result = calibrate::calibrate(task);
  // For a link, the file that it refers to is written.
  const std::string file = arguments.in_place ? fs::canonical(arguments.robot).string() : arguments.out;
  std::string written;
  if (!file.empty()) written = calibrate::calibrated_text(task, result, file);
  if (!arguments.plot.empty()) write_file(arguments.plot, calibrate::plot(result));
  if (!file.empty()) write_file(file, written);
  std::string text = calibrate::report(result);
  for (const std::string& name : {arguments.plot, arguments.in_place ? arguments.robot : file})
    if (!name.empty()) text += name + " is written\n";
  if (file.empty()) text += "no robot file is written: that takes --out FILE or --in-place\n";
  print(text);
  return static_cast<int>(ExitStatus::ok);
}

}  // namespace robosim::cli
