// The history of the board's supply. A verdict mentions the supply if it caused a robot to stop or get lost.
#pragma once

#include <optional>
#include <string>

#include "hal/board/sim_time.h"

namespace robosim::judge {

struct SupplySummary {
  bool on = true;                ///< the chip runs
  bool switched_on = true;       ///< the script has not switched it off
  SimTime since = 0;             ///< time of the last change
  int resets = 0;                ///< number of resets because of low voltage
  std::optional<double> charge;  ///< of a [battery], 0..1; below 0 its voltage collapses
  double volts = 0.0;            ///< V, of the battery under load
  double needed = 0.0;           ///< V, of the battery, required for the chip to run

  bool empty() const { return charge && *charge <= 0.0; }
};

/// Returns "the board has had no power since 7.28 s: its battery is empty"; empty if the supply explains
/// nothing.
std::string told(const SupplySummary& power);

}  // namespace robosim::judge
