// Simulates power cuts during EEPROM writes. Repeats a run three times for each byte that the firmware
// writes. In each repetition, the power fails in the middle of one write.
//
// A byte with an interrupted write may have any value (the chip erases the byte to 0xFF, then clears bits).
// Three values represent all of them: the old value (write not begun), 0xFF (erased), the new value
// (complete).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/launch/client/pool.h"

namespace robosim::client {

/// A power failure of 20 ms during one write to the EEPROM.
struct PowerCut {
  std::uint64_t write = 0;  ///< number of the interrupted write to the EEPROM, from 1
  std::string byte;         ///< the byte's value after the cut, in a script's words: "old", "erased", "new"

  /// Returns the line of a script for this cut.
  std::string script() const;
  /// Returns a description, such as "power cut during write 12 to the EEPROM, its byte left erased".
  std::string text() const;
};

/// Returns three cuts for each write.
std::vector<PowerCut> all_power_cuts(std::uint64_t writes);

/// Receives the answer of each run with a cut, in the order of all_power_cuts(), regardless of the pool's
/// size.
using OnPowerCut = std::function<void(const PowerCut&, Answer)>;

/// Runs `task` without a cut and counts the EEPROM writes. Repeats the run with each cut of these writes.
/// Returns the answer of the run without a cut; if this answer is a Failure, there are no repetitions. A
/// write that occurs only in a repetition is not cut. If the pool is interrupted, `cut` is not called for
/// unfinished runs.
Answer run_with_power_cuts(Pool& pool, const Task& task, const OnPowerCut& cut);

}  // namespace robosim::client
