// Reads measurements by stopwatch and tape measure, for robots without encoders, from a TOML file.
//
//   supply = "7.4 V"              # the battery's voltage during the drives; --supply can replace this line
//   [[drive]]
//   pwm = 255                     # command of both motors, from rest
//   time = "1 s"                  # then all pins low
//   distance = "1180 mm"          # from standstill to standstill
//   measured = "10 mm"            # uncertainty; default 10 mm
#pragma once

#include <string>
#include <vector>

#include "sim/campaign/calibrate/drive_fit.h"

namespace robosim::calibrate {

struct Stopwatch {
  double supply_volts = 0.0;  ///< 0 = not given
  std::vector<Timed> drives;
};

/// Reads the file. Throws InputError, which names the file and line.
Stopwatch read_stopwatch(const std::string& file);

}  // namespace robosim::calibrate
