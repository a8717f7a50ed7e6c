// A power cut at every possible place: the same run once more for each byte of EEPROM that the firmware
// writes, with the power failing in the middle of that write.
//
// A byte whose writing was cut off may hold anything (the chip erases it to 0xFF, then clears bits); three
// contents stand for that: the old one (nothing had happened yet), 0xFF (it was erased), the new one (it was
// done).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/client/pool.h"

namespace robosim::client {

/// One place at which the power fails, for 20 ms.
struct PowerCut {
  std::uint64_t write = 0;  ///< during this write to the EEPROM, from 1
  std::string byte;         ///< what the byte then holds, in a script's words: "old", "erased", "new"

  /// The script's line that makes it.
  std::string script() const;
  /// In words: "power cut during write 12 to the EEPROM, its byte left erased".
  std::string text() const;
};

/// Three for each write.
std::vector<PowerCut> all_power_cuts(std::uint64_t writes);

/// Called for each run with a cut, in the order of all_power_cuts(), whatever the pool's size.
using OnPowerCut = std::function<void(const PowerCut&, Answer)>;

/// Runs `task` as it is, then with each cut, and gives the answer of the run without any, whose writes were
/// counted; if it is a Failure, nothing was cut. Writes that only happen after a cut are not cut again.
/// Where the pool is interrupted, runs are missing.
Answer run_with_power_cuts(Pool& pool, const Task& task, const OnPowerCut& cut);

}  // namespace robosim::client
