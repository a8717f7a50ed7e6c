// Fits motor parameters to drives from rest. The body of sim/world/body.h gets the motor commands of the log.
// The body's parameters are changed until the angles of its wheels match the encoder counts.
//
// A wheel has torque constant k_t (N m per ampere), back EMF k_e (volts per rad/s), resistance R, friction
// torque M and inertia J. The drives determine
//   by the speed at each voltage:    k_e, and R M / k_t
//   by the time constant:            R J / (k_t k_e)
//   by the coasting:                 M / J
// These values give k_e, and the ratios of k_t / R to M and to J, but neither R nor J. With R (stall_current)
// and J (mass, rotor, wheels) from the file, they give no_load, stall_torque and no_load_current. If J is
// wrong, stall_torque is wrong by the same factor, and the simulated robot still behaves correctly. Turns on
// the spot determine the body's inertia about its vertical axis.
//
// The uncertainty is computed from the residuals and their derivatives with respect to each parameter. The
// uncertainty includes the file's spreads of fixed values (mass, supply, stall_current, rolling). Residuals
// of neighbouring samples are correlated, so n samples count as n / 10.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "sim/campaign/calibrate/log.h"
#include "sim/campaign/calibrate/sweep_fit.h"
#include "sim/robot/description.h"

namespace robosim::calibrate {

/// A measurement by stopwatch and tape measure. The motors get this command from rest, for `seconds`, and
/// then coast.
struct Timed {
  std::string file;
  int line = 0;
  int told = 0;           ///< command for both motors, 1 .. 255
  double seconds = 0.0;   ///< duration of the command
  double distance = 0.0;  ///< m, from standstill to standstill
  double sd = 0.0;        ///< m, uncertainty of the measurement
};

/// A measured and a fitted drive, for plots.
struct DriveCurve {
  std::vector<double> t;                        ///< s
  std::array<std::vector<double>, 2> measured;  ///< turns of each wheel
  std::array<std::vector<double>, 2> fitted;
  std::array<int, 2> told{};  ///< first command of each motor
};

struct DriveFit {
  std::array<Found, 2> no_load;  ///< rad/s, of each motor at [motors] voltage
  Found stall_torque;            ///< N m
  Found no_load_current;         ///< A
  Found inertia;                 ///< kg m2, of the body about its vertical axis; value 0: undetermined
  Found time_constant;           ///< s, straight on, with the present driver and battery
  double rms = 0.0;              ///< root mean square of the residuals, in their units (Bench)
  bool torque_told = true, friction_told = true;
  std::vector<DriveCurve> curves;
};

/// Fits the drives; returns nothing if there are no drives. `supply` is the battery voltage measured during
/// the drives. If the value of `supply` is 0, uses the file's voltage and spread. Throws InputError if a
/// motor does not move, or moves in the wrong direction.
std::optional<DriveFit> fit_drives(const std::vector<Log>& logs, const std::vector<Timed>& timed,
                                   const robot::Description& robot, Found supply);

}  // namespace robosim::calibrate
