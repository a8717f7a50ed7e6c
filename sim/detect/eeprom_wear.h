// Finds EEPROM wear: a byte that is written so often that its memory cell wears out.
//
//   void loop() { …  EEPROM.write(0, speed); }
//
// A byte of an ATmega's EEPROM lasts for 100,000 writes (ATmega328P, DS40002061B, 8.4: "an endurance of at
// least 100,000 write/erase cycles"). A sketch that writes in each pass of loop() reaches this number in six
// minutes, since a write takes 3.4 ms. The wear goes unnoticed on the bench. Weeks later the robot has lost
// its settings, and cannot store new settings.
//
// A finding is the first byte that has met one of these conditions since the last power-on:
//
//   - the byte was written 10 times, over at least a second, with the value that the byte already had;
//   - the byte was written 20 times, over at least five seconds, at a rate that wears the byte out within a
//     day.
//
// Sketches that save when a button is pressed, or by update() when a value has changed, are not reported. To
// fix a finding, use EEPROM.update(), which writes only changed bytes. Alternatively, save less often, or
// write to several bytes in turn.
//
// Not detected: wear from years of rare writes; writes of earlier runs; wear of other memories such as flash.
// If two lines write the same byte, the finding names the line whose write met the condition.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "sim/detect/firmware_detector.h"

namespace robosim::detect {

class EepromWear final : public FirmwareDetector, public EepromWatcher {
 public:
  EepromWear(exec::Executor& executor, SnapshotRegistry& snapshots);

  /// Clears all counts.
  void powered_on() override { state_.cells.clear(); }
  void eeprom_written(std::uint16_t address, std::uint8_t before, std::uint8_t value, SimTime t) override;
  std::vector<exec::Detected> found(SimTime) const override;

 private:
  struct Cell {
    SimTime began = 0, last = 0;
    std::int64_t writes = 0, needless = 0;
    double lasts_s() const;  ///< seconds until the byte is worn out, at the present rate of writes
  };
  struct Found {
    std::uint16_t address = 0;
    result::SourceLine where;
    SimTime first = 0;
    Cell cell;
  };

  struct State {
    std::map<std::uint16_t, Cell> cells;
    std::optional<Found> found;
  };

  exec::Executor& executor_;
  State state_;
};

}  // namespace robosim::detect
