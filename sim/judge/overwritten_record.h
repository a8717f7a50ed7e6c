// Finds a record in EEPROM in which each byte overwrites the previous byte.
//
//   void put(uint8_t byte) { EEPROM.update(at, byte); }        // at++ was forgotten
//
// Only the last byte of a stored map, log or set of numbers remains. The fault goes unnoticed until the
// sketch reads the record after the next power-on.
//
// A finding is the first byte that was written 8 times in immediate succession. The values differ, and no
// other byte is written in between. Nothing could have read the earlier values in such a short time.
//
// Bursts of more than 5 s are not reported here. A sketch that stores a number in each pass of loop() causes
// wear (eeprom_wear.h). Not detected: shorter records, and records whose bytes are equal.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/exec/core/executor.h"

namespace robosim::judge {

class OverwrittenRecord {
 public:
  static constexpr const char* kName = "overwritten_record";

  /// Ends the series of writes when the firmware starts.
  void powered_on() { row_ = {}; }
  /// Handles a byte whose write begins at `t`. `executor` provides the source line if the write makes a
  /// finding.
  void written(std::uint16_t address, std::uint8_t before, std::uint8_t value, SimTime t,
               exec::Executor& executor);
  std::vector<exec::Detected> found() const;

 private:
  struct Row {
    std::uint16_t address = 0;
    SimTime began = 0, last = 0;
    std::int64_t writes = 0;
    result::SourceLine where = {};  ///< source line of the write that made a finding
    SimTime found = 0;
  };

  Row row_;
  std::optional<Row> found_;
};

}  // namespace robosim::judge
