// Simulates a power cut at every possible place. Repeats the run for each byte of EEPROM that the firmware
// writes. The power fails in the middle of that write.
//
// A byte with an interrupted write may have any value (the chip erases the byte to 0xFF, then clears bits).
// Three values represent all of them: the old value (not begun), 0xFF (erased), the new value (complete).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/launch/client/pool.h"

namespace robosim::client {

/// A power failure of 20 ms at one place.
struct PowerCut {
  std::uint64_t write = 0;  ///< number of the interrupted write to the EEPROM, from 1
  std::string byte;         ///< the byte's value after the cut, in a script's words: "old", "erased", "new"

  /// Returns the line of a script for this cut.
  std::string script() const;
  /// Returns "power cut during write 12 to the EEPROM, its byte left erased".
  std::string text() const;
};

/// Returns three cuts for each write.
std::vector<PowerCut> all_power_cuts(std::uint64_t writes);

/// Receives each run with a cut, in the order of all_power_cuts(), regardless of the pool's size.
using OnPowerCut = std::function<void(const PowerCut&, Answer)>;

/// Runs `task` unchanged, then with each cut. Returns the answer of the unchanged run, in which writes were
/// counted. If that answer is a Failure, there are no cuts. Writes that occur only after a cut are not cut
/// again. If the pool is interrupted, runs are missing.
Answer run_with_power_cuts(Pool& pool, const Task& task, const OnPowerCut& cut);

}  // namespace robosim::client
