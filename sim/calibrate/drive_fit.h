// What drives from rest tell of motors: the body of sim/world/body.h is driven as the log says, and its
// figures are changed until its wheels' angles are what the encoders have counted.
//
// Steps tell, of a wheel with torque k_t for each ampere, k_e volts for each rad/s, resistance R and inertia
// J,
//   its speed at each voltage:    k_e, and R friction / k_t
//   its time constant:            R J / (k_t k_e)
//   how it rolls out:             friction / J
// and so k_e and the two ratios of k_t, friction and J: not R, not J. With the file's R (stall_current) and J
// (mass, rotor, wheels) these are no_load, stall_torque and no_load_current; if J is wrong, stall_torque is
// by as much, and what the robot does is right all the same. From turns on the spot comes the body's inertia
// about its axis.
//
// How sure: from the residuals and how each figure changes them, the file's own spreads of what is held
// (mass, supply, stall_current, rolling) included. Residuals of neighbouring samples are alike, so that for n
// samples n / 10 are counted.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "sim/calibrate/log.h"
#include "sim/calibrate/sweep_fit.h"
#include "sim/robot/description.h"

namespace robosim::calibrate {

/// A row of stopwatch and tape measure: from rest the motors are told this for so long, then they roll out.
struct Timed {
  std::string file;
  int line = 0;
  int told = 0;           ///< both motors, 1 .. 255
  double seconds = 0.0;   ///< how long
  double distance = 0.0;  ///< m, from where it stood to where it stands
  double sd = 0.0;        ///< m, how well that is measured
};

/// A drive as it was and as it was fitted, for plots.
struct DriveCurve {
  std::vector<double> t;                        ///< s
  std::array<std::vector<double>, 2> measured;  ///< turns of each wheel
  std::array<std::vector<double>, 2> fitted;
  std::array<int, 2> told{};  ///< at first
};

struct DriveFit {
  std::array<Found, 2> no_load;  ///< rad/s, each motor at [motors] voltage
  Found stall_torque;            ///< N m
  Found no_load_current;         ///< A
  Found inertia;                 ///< kg m2; value 0: not told
  Found time_constant;           ///< s, straight on, of the driver and the battery as they are
  double rms = 0.0;              ///< of the residuals: counts, or m by stopwatch
  bool torque_told = true, friction_told = true;
  std::vector<DriveCurve> curves;
};

/// `supply`: as measured meanwhile; without it the file's counts, with its spread. Throws InputError where a
/// motor does not move, or moves the wrong way.
std::optional<DriveFit> fit_drives(const std::vector<Log>& logs, const std::vector<Timed>& timed,
                                   const robot::Description& robot, Found supply);

}  // namespace robosim::calibrate
