// Converts a sensor's readings in a sweep to a signal, and finds the crossings of the tape in the signal.
#pragma once

#include <string>
#include <vector>

#include "sim/campaign/calibrate/log.h"
#include "sim/robot/description.h"
#include "sim/robot/parts/reflectance.h"

namespace robosim::calibrate {

/// The signal of one element in one sweep.
struct Trace {
  const Sweep* sweep = nullptr;
  const std::string* file = nullptr;
  std::vector<double> y;      ///< V; for RC sensors, 1 / s
  std::vector<double> angle;  ///< rad, rotation of the robot, from its encoder counts; empty without counts
  double radius = 0.0;        ///< m from the centre of the turn to the sensor; 0 without encoder counts
  double step = 0.0;          ///< difference of the signal between adjacent codes; 0 for RC sensors
  double timing = 0.0;        ///< s: resolution of an RC sensor's time; 0 = exact
};

/// One crossing of the tape.
struct Crossing {
  double enters = 0.0, leaves = 0.0;  ///< s, when the signal is halfway between floor and tape
  std::size_t first = 0, last = 0;    ///< first and last sample between these times
  double speed = 0.0;                 ///< m/s across the tape
};

struct Levels {
  double white = 0.0, black = 0.0;
};

/// Returns the trace of the element with this index in its part. Throws InputError for a reading that is not
/// a code of the converter.
Trace make_trace(const Log&, const Sweep&, std::size_t column, const robot::ReflectanceSpec&,
                 std::size_t element, const robot::Description&);

/// Returns the approximate signals over the floor and over the tape. Throws InputError if the two signals are
/// nearly equal, reversed, or at the converter's limit.
Levels rough_levels(const Trace&, const std::string& name, const robot::ReflectanceSpec&);

/// Returns the complete crossings: floor, tape, floor. Throws InputError if no crossing is complete, or if
/// the tape's width by the wheels contradicts `tape_m`.
std::vector<Crossing> find_crossings(const Trace&, const std::string& name, const Levels&, double tape_m);

}  // namespace robosim::calibrate
