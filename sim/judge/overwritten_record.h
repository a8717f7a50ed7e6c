// A record in EEPROM of which each byte is written over the one before.
//
//   void put(uint8_t byte) { EEPROM.update(at, byte); }        at++ was forgotten
//
// A map, a log or a set of numbers is stored, and what is there afterwards is its last byte. Nothing is seen
// of it until the robot is switched on again and reads.
//
// What is found is the first byte that was written 8 times, one right after the other, nothing else between
// them, each time with another value: so fast no other firmware could have read it.
//
// Who stores one number in each pass of loop() does the same for longer: that is wear (eeprom_wear.h), and a
// burst of more than 5 s is not told here. What it cannot see: shorter records, and those whose bytes are
// alike.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/exec/core/executor.h"

namespace robosim::judge {

class OverwrittenRecord {
 public:
  static constexpr const char* kName = "overwritten_record";

  /// The firmware has started.
  void powered_on() { row_ = {}; }
  /// Each byte whose writing begins at `t`; `executor` is asked for the line where it makes a finding.
  void written(std::uint16_t address, std::uint8_t before, std::uint8_t value, SimTime t,
               exec::Executor& executor);
  std::vector<exec::Detected> found() const;

 private:
  struct Row {
    std::uint16_t address = 0;
    SimTime began = 0, last = 0;
    std::int64_t writes = 0;
    wire::SourceLine where = {};  ///< of the one that made it a finding
    SimTime found = 0;
  };

  Row row_;
  std::optional<Row> found_;
};

}  // namespace robosim::judge
