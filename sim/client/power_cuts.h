// Simulates a power cut at every possible place. Repeats the run for each byte of EEPROM that the firmware
// writes, with a power failure in the middle of that write.
//
// A byte with an interrupted write may hold any value (the chip erases it to 0xFF, then clears bits). Three
// values represent that: the old one (not begun), 0xFF (erased), the new one (complete).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/client/pool.h"

namespace robosim::client {

/// A power failure of 20 ms at one place.
struct PowerCut {
  std::uint64_t write = 0;  ///< during this write to the EEPROM, from 1
  std::string byte;         ///< the byte's value afterwards, in a script's words: "old", "erased", "new"

  /// Returns its line of a script.
  std::string script() const;
  /// Returns "power cut during write 12 to the EEPROM, its byte left erased".
  std::string text() const;
};

/// Returns three for each write.
std::vector<PowerCut> all_power_cuts(std::uint64_t writes);

/// Called for each run with a cut, in the order of all_power_cuts(), regardless of the pool's size.
using OnPowerCut = std::function<void(const PowerCut&, Answer)>;

/// Runs `task` unchanged, then with each cut, and returns the answer of the run without a cut, in which
/// writes were counted. If that is a Failure, there are no cuts. Writes that only happen after a cut are not
/// cut again. If the pool is interrupted, runs are missing.
Answer run_with_power_cuts(Pool& pool, const Task& task, const OnPowerCut& cut);

}  // namespace robosim::client
