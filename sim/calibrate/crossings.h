// A sensor's readings in a sweep as a signal, and where in it the tape is.
#pragma once

#include <string>
#include <vector>

#include "sim/calibrate/log.h"
#include "sim/robot/description.h"
#include "sim/robot/parts/reflectance.h"

namespace robosim::calibrate {

/// What one element gave in one sweep.
struct Trace {
  const Sweep* sweep = nullptr;
  const std::string* file = nullptr;
  std::vector<double> y;      ///< volts, or 1 / s
  std::vector<double> angle;  ///< rad the robot has turned, by its wheels; empty without counts
  double radius = 0.0;        ///< m from what it turns about to the sensor; with counts
  double step = 0.0;          ///< of the signal, from code to code; 0 of RC sensors
  double timing = 0.0;        ///< s: how finely an RC sensor's time is known; 0 = exactly
};

/// One passage over the tape.
struct Crossing {
  double enters = 0.0, leaves = 0.0;  ///< s, at half depth
  std::size_t first = 0, last = 0;    ///< the samples between
  double speed = 0.0;                 ///< m/s across the tape
};

struct Levels {
  double white = 0.0, black = 0.0;
};

/// Of an element with this index in its part. Throws InputError for a reading that is no code of the
/// converter.
Trace make_trace(const Log&, const Sweep&, std::size_t column, const robot::ReflectanceSpec&,
                 std::size_t element, const robot::Description&);

/// Roughly what it gives over floor and tape. Throws InputError if that is all the same, or the wrong way
/// round, or at the converter's end.
Levels rough_levels(const Trace&, const std::string& name, const robot::ReflectanceSpec&);

/// The whole passages: floor, tape, floor. Throws InputError where there is none, or where wheels and tape
/// contradict each other.
std::vector<Crossing> find_crossings(const Trace&, const std::string& name, const Levels&, double tape_m);

}  // namespace robosim::calibrate
