// Finds a record in EEPROM of which each byte overwrites the previous one.
//
//   void put(uint8_t byte) { EEPROM.update(at, byte); }        // at++ was forgotten
//
// A map, a log or a set of numbers is stored, and only its last byte remains. It goes unnoticed until the
// robot is switched on again and reads.
//
// A finding is the first byte that was written 8 times in immediate succession, with different values and
// without other writes in between. No other firmware could have read it so fast.
//
// A sketch that stores one number in each pass of loop() does so for longer. That is wear (eeprom_wear.h), so
// bursts of more than 5 s are not reported here. Not detected: shorter records, and those whose bytes are
// equal.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/exec/core/executor.h"

namespace robosim::judge {

class OverwrittenRecord {
 public:
  static constexpr const char* kName = "overwritten_record";

  /// Notes that the firmware has started.
  void powered_on() { row_ = {}; }
  /// Handles each byte whose write begins at `t`; `executor` returns the line if it makes a finding.
  void written(std::uint16_t address, std::uint8_t before, std::uint8_t value, SimTime t,
               exec::Executor& executor);
  std::vector<exec::Detected> found() const;

 private:
  struct Row {
    std::uint16_t address = 0;
    SimTime began = 0, last = 0;
    std::int64_t writes = 0;
    wire::SourceLine where = {};  ///< of the write that made it a finding
    SimTime found = 0;
  };

  Row row_;
  std::optional<Row> found_;
};

}  // namespace robosim::judge
