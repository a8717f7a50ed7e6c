// Reads logs of a real robot, as samples/CalibrationLogger writes them (docs/howto/calibrating.md). A log
// contains tables of comma separated numbers, each under a line of column names.
//
//   # counts_per_period = 2               counted edges per period of an encoder's channel
//   # timing_step_us = 9.5                for RC sensors: time between two reads of a pin
//   t_us,count_left,count_right,S1,S2     a sweep: the robot turns slowly over floor and tape
//   t_us,left,right,count_left,count_right    a drive from rest: each motor's command from t_us on,
//                                             -255 .. 255 (0 = coast), and encoder counts
//
// Counts are positive forward. Other lines that begin with # are comments. The prefix that a serial monitor
// adds to a line ("12:00:01.123 -> ") is skipped. A board restarts when the serial monitor opens the port.
// Therefore everything before the last "# robosim calibration log" is skipped, too.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace robosim::calibrate {

struct Sweep {
  int line = 0;                               ///< line of the column names
  std::vector<int> lines;                     ///< line of each row
  std::vector<double> t;                      ///< s
  bool counted = false;                       ///< the sweep has counts
  std::array<std::vector<double>, 2> count;   ///< left, right
  std::vector<std::string> names;             ///< names of the sensors
  std::vector<std::vector<double>> readings;  ///< readings of each sensor, as the sketch read them
};

struct Drive {
  int line = 0;
  std::vector<int> lines;
  std::vector<double> t;                     ///< s
  std::array<std::vector<int>, 2> told;      ///< left, right: -255 .. 255
  std::array<std::vector<double>, 2> count;  ///< left, right
};

struct Log {
  std::string file;
  std::optional<double> counts_per_period;
  double timing_step = 0.0;  ///< s; 0 = not given
  std::vector<Sweep> sweeps;
  std::vector<Drive> drives;
};

/// Parses a log. Throws InputError with file and line.
Log parse_log(std::string_view text, const std::string& file);

}  // namespace robosim::calibrate
