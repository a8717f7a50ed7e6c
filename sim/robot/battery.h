// Models the table [battery] of a robot file: cells that discharge, and whose voltage sags under load.
// Without this table, the motors' voltage is always `supply` of [motors].
//
//   V = cells OCV(charge) - R I
//   I = board + sum over the motors of |drive| max(0, V - drop - k_e w) / (motor ohms)
//   d charge / dt = - I / capacity
//
// `cells` is the number of cells, OCV a cell's open-circuit voltage, and R the `resistance`. `board` is the
// current of everything except the motors. `drive` is a motor's command, `drop` its driver's voltage drop,
// and k_e w its back EMF.
//
// V is solved exactly in each tick, since I is piecewise linear in V (world::Body::draw). For example, let E
// be the voltage at rest, and R_m the resistance of a motor with its driver. Two stalled motors lower the
// voltage to
//
//   V = (E + R (2 drop / R_m - board)) / (1 + 2 R / R_m)
//
// Below a charge of 0 the cells collapse: the voltage falls linearly to 0 V at a charge of -2 %.
//
// battery.cpp has the open-circuit voltages of a cell. The values for li-ion were measured by
// github.com/little-porter, battery_health_inference_RJ. The values for nimh and alkaline are estimates from
// makers' discharge curves at 0.2 C. Without the key `resistance`, each cell has a typical resistance of its
// kind. This value was not measured. The resistance does not depend on the charge.
//
// Not modelled: recovery after load, temperature, and the cut-off of a protection circuit. Current flows back
// into the battery only if the motors have an inductance.
#pragma once

#include "sim/base/config.h"
#include "sim/base/parameter.h"
#include "sim/world/body.h"

namespace robosim::robot {

struct BatteryKind {
  const char* name;
  double ohms;       ///< resistance of a cell
  double volts[11];  ///< voltages of a cell at rest, at 100, 90 ... 0 % of its charge
};

struct Battery {
  const BatteryKind* kind = nullptr;  ///< null = the robot has no battery
  double cells = 0.0;
  Parameter resistance;   ///< ohm, of all cells and their leads
  Parameter capacity_as;  ///< A s
  Parameter charge;       ///< 0..1 at the start
  Parameter board;        ///< A, the current of everything except the motors
};

/// Reads the table [battery]. Throws InputError.
Battery read_battery(const ConfigValue& table);

/// One robot's battery, with its sampled parameters.
struct Cells {
  const BatteryKind* kind = nullptr;
  double cells = 0.0, ohms = 0.0, capacity_as = 0.0, board_amps = 0.0;

  /// Returns the voltage at rest.
  double rest_volts(double charge) const;
  /// The voltage under a load, and the share of the charge (0..1) that one tick uses.
  struct Load {
    double volts, taken;
  };
  Load under(const world::Body& motors, double charge) const;
};

}  // namespace robosim::robot
