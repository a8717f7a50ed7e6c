// Drives by stopwatch and tape measure, for robots without encoders: a TOML file.
//
//   supply = "7.4 V"              # the battery meanwhile; or --supply
//   [[drive]]
//   pwm = 255                     # of both motors, from rest
//   time = "1 s"                  # then all pins low
//   distance = "1180 mm"          # between the standstills
//   measured = "10 mm"            # uncertainty; default 10 mm
#pragma once

#include <string>
#include <vector>

#include "sim/calibrate/drive_fit.h"

namespace robosim::calibrate {

struct Stopwatch {
  double supply_volts = 0.0;  ///< 0 = not given
  std::vector<Timed> drives;
};

/// Reads the file. Throws InputError with file and line.
Stopwatch read_stopwatch(const std::string& file);

}  // namespace robosim::calibrate
