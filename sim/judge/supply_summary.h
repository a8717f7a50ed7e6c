// Summarises the history of the board's supply. The explanation of a verdict mentions the supply if it may
// have caused the verdict.
#pragma once

#include <optional>
#include <string>

#include "hal/board/sim_time.h"

namespace robosim::judge {

struct SupplySummary {
  bool on = true;                ///< the board has power
  bool switched_on = true;       ///< the script has not switched the supply off
  SimTime since = 0;             ///< time at which `on` last changed
  int resets = 0;                ///< number of resets because of low voltage
  SimTime recovered = 0;         ///< when the chip last ran again after such a reset
  std::optional<double> charge;  ///< of a [battery]: 1 = full, 0 = empty; below 0 the voltage collapses
  double volts = 0.0;            ///< V, voltage of the battery under load
  double needed = 0.0;           ///< V, battery voltage that the chip requires to run

  bool empty() const { return charge && *charge <= 0.0; }
};

/// Returns a clause such as "the board has had no power since 7.28 s: its battery is empty". Returns "" if
/// the supply has not affected the run.
std::string told(const SupplySummary& power);

}  // namespace robosim::judge
