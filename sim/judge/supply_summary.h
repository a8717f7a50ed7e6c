// The history of the board's supply. A verdict names it if a robot stands still or gets lost because of it.
#pragma once

#include <optional>
#include <string>

#include "hal/board/sim_time.h"

namespace robosim::judge {

struct SupplySummary {
  bool on = true;                ///< the chip runs
  bool switched_on = true;       ///< by the script
  SimTime since = 0;             ///< the last change
  int resets = 0;                ///< because of low voltage
  std::optional<double> charge;  ///< of a [battery], 0..1; below 0 it collapses
  double volts = 0.0;            ///< V of the battery, under load
  double needed = 0.0;           ///< V of the battery that the chip needs to run

  bool empty() const { return charge && *charge <= 0.0; }
};

/// Returns "the board has had no power since 7.28 s: its battery is empty"; empty if the supply explains
/// nothing.
std::string told(const SupplySummary& power);

}  // namespace robosim::judge
