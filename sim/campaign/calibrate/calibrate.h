// Implements `robosim calibrate`: computes parameters of a robot file from logs of the real robot
// (docs/howto/calibrating.md).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/campaign/calibrate/figures.h"

namespace robosim::calibrate {

struct Task {
  std::string robot;              ///< file, or name of a stock robot
  std::vector<std::string> logs;  ///< file names
  std::string stopwatch;          ///< file name; empty = none
  double tape_m = 0.0;            ///< 0 = not given
  double supply_volts = 0.0;      ///< 0 = not measured
};

struct Calibration {
  robot::Description robot;
  SweepFit sweep;
  std::optional<DriveFit> drive;
  std::vector<Figure> figures;        ///< certain enough to be written to the robot file
  std::vector<Figure> unsure;         ///< found, but too uncertain
  std::vector<std::string> not_told;  ///< values that these logs do not determine, one sentence each
  double tape_m = 0.0;
};

/// Computes the parameters. Throws InputError.
Calibration calibrate(const Task&);

/// Returns a report for the user.
std::string report(const Calibration&);

/// Returns the robot file's text with the parameters. For a stock robot, returns a file that is based on that
/// robot. Checks the text by parsing it as `file`. Throws InputError.
std::string calibrated_text(const Task&, const Calibration&, const std::string& file);

}  // namespace robosim::calibrate
