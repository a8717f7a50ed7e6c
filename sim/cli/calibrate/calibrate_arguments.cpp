#include "sim/cli/calibrate/calibrate_arguments.h"

#include <fmt/format.h>

#include "sim/base/error.h"
#include "sim/base/units.h"
#include "sim/cli/options.h"

namespace robosim::cli {
namespace {

double quantity(const char* option, const std::string& text, Dimension dimension, double least, double most,
                const char* allowed) {
  const auto value = parse_quantity(text, dimension);
  if (!value || *value < least || *value > most) refuse_value(option, text, allowed);
  return *value;
}

}  // namespace

Command parse_calibrate(const std::vector<std::string>& words) {
  CalibrateArguments calibrate;
  std::string tape, supply;
  Options options("calibrate", "fit a robot file to logs of the real robot",
                  "Reports how uncertain each value is.");
  options.positional("ROBOT", calibrate.robot, "fit this robot file", PossibleValues::robot());
  options.positionals("LOG", calibrate.logs, "read these logs, which the sketch CalibrationLogger printed",
                      PossibleValues::file());
  options.text("--tape", tape, "WIDTH",
               "set the width of the tape that the sensors crossed, as in \"19 mm\"");
  options.text("--supply", supply, "VOLTS", "set the battery's voltage during the log, as in \"7.4 V\"");
  options.text("--stopwatch", calibrate.stopwatch, "FILE",
               "read drives, measured by stopwatch and tape, from this TOML file", PossibleValues::file());
  options.text("--out", calibrate.out, "FILE", "write the fitted robot to this new file",
               PossibleValues::file());
  options.flag("--in-place", calibrate.in_place, "write the fitted values into the robot file itself");
  options.text("--plot", calibrate.plot, "FILE", "draw the measured values against the fitted ones, as .svg",
               PossibleValues::file());
  if (const auto help = options.parse(words)) return *help;
  if (calibrate.robot.empty())
    throw InputError(
        "robosim calibrate requires a robot file and a log, as in robosim calibrate robot.toml log.csv "
        "--tape "
        "\"19 mm\"");
  if (calibrate.logs.empty() && calibrate.stopwatch.empty())
    throw InputError("robosim calibrate requires a log, or --stopwatch FILE");
  if (!tape.empty())
    calibrate.tape_m = quantity("--tape", tape, Dimension::length, 0.003, 0.1,
                                "a width from 3 mm to 100 mm, as in \"19 mm\"");
  if (!supply.empty())
    calibrate.supply_volts = quantity("--supply", supply, Dimension::voltage, 1.0, 30.0,
                                      "a voltage from 1 V to 30 V, as in \"7.4 V\"");
  if (!calibrate.out.empty() && calibrate.in_place)
    throw InputError("--out and --in-place exclude each other; give one of them");
  if (!calibrate.plot.empty() && calibrate.plot == calibrate.out)
    throw InputError(fmt::format("--out and --plot both name {}; give them different files", calibrate.out));
  if (!calibrate.plot.empty() && !calibrate.plot.ends_with(".svg"))
    refuse_value("--plot", calibrate.plot, "a file that ends in .svg");
  return calibrate;
}

}  // namespace robosim::cli
