// [battery]: cells that sag under load, and discharge. Without it the motors have [motors] supply under any
// load.
//
//   V = cells OCV(charge) - R I
//   I = board + sum over the motors of |drive| max(0, V - drop - k_e w) / (its ohms)
//   d charge / dt = - I / capacity
//
// V is solved exactly in each tick, since I is piecewise linear in V (world::Body::draw). So two stalled
// motors, each of R_m with its driver, lower the rest voltage E to
//
//   V = (E + R (2 drop / R_m - board)) / (1 + 2 R / R_m)
//
// Below a charge of 0 the cells collapse, to no voltage at -2 %.
//
// Open-circuit volts of a cell (battery.cpp): li-ion as measured by github.com/little-porter,
// battery_health_inference_RJ; nimh and alkaline are estimates from makers' discharge curves at 0.2 C. If the
// file has no resistance of a cell, it is a usual value of its kind: not measured, the same at any charge.
//
// Not modelled: recovery after load, temperature, a protection's cut-off; without inductance, current that
// flows back.
#pragma once

#include "sim/base/config.h"
#include "sim/base/parameter.h"
#include "sim/world/body.h"

namespace robosim::robot {

struct BatteryKind {
  const char* name;
  double ohms;       ///< of a cell
  double volts[11];  ///< of a cell at rest, at 100, 90 ... 0 % of its charge
};

struct Battery {
  const BatteryKind* kind = nullptr;  ///< null: there is none
  double cells = 0.0;
  Parameter resistance;   ///< ohm, of all, with their leads
  Parameter capacity_as;  ///< A s
  Parameter charge;       ///< 0..1 at the start
  Parameter board;        ///< A that all but the motors takes
};

/// Reads [battery]. Throws InputError.
Battery read_battery(const ConfigValue& table);

/// One robot's battery, with its drawn parameters.
struct Cells {
  const BatteryKind* kind = nullptr;
  double cells = 0.0, ohms = 0.0, capacity_as = 0.0, board_amps = 0.0;

  /// V at rest.
  double rest_volts(double charge) const;
  /// V while it feeds these motors, and what of its charge a tick takes, 0..1.
  struct Load {
    double volts, taken;
  };
  Load under(const world::Body& motors, double charge) const;
};

}  // namespace robosim::robot
