// Finds a record in EEPROM in which each byte overwrites the previous byte.
//
//   void put(uint8_t byte) { EEPROM.update(at, byte); }        // the programmer forgot at++
//
// Only the last byte of a stored map, log or set of numbers remains. The fault goes unnoticed until the
// sketch reads the record after the next power-on.
//
// A finding is the first byte that was written 8 times in immediate succession. Each write changes the value,
// and no other byte is written in between. The time between the writes is too short to read the values.
//
// A series of writes that lasts longer than 5 s is not reported. If a sketch stores a number in each pass of
// loop(), EepromWear reports wear (eeprom_wear.h). Not detected: records of fewer than 8 bytes, and records
// in which a byte equals the previous byte.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/detect/firmware_detector.h"

namespace robosim::detect {

class OverwrittenRecord final : public FirmwareDetector, public EepromWatcher {
 public:
  OverwrittenRecord(exec::Executor& executor, SnapshotRegistry& snapshots);

  /// Ends the current series of writes.
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
