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

#include "sim/detect/firmware_detector.h"

namespace robosim::detect {

class OverwrittenRecord final : public FirmwareDetector, public EepromWatcher {
 public:
  OverwrittenRecord(exec::Executor& executor, SnapshotRegistry& snapshots);

  /// Ends the series of writes.
  void powered_on() override { state_.row = {}; }
  void eeprom_written(std::uint16_t address, std::uint8_t before, std::uint8_t value, SimTime t) override;
  std::vector<exec::Detected> found(SimTime) const override;

 private:
  struct Row {
    std::uint16_t address = 0;
    SimTime began = 0, last = 0;
    std::int64_t writes = 0;
    result::SourceLine where = {};  ///< source line of the write that made a finding
    SimTime found = 0;
  };

  struct State {
    Row row;
    std::optional<Row> found;
  };

  exec::Executor& executor_;
  State state_;
};

}  // namespace robosim::detect
