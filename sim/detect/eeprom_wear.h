// Finds EEPROM wear: a byte that is written again and again.
//
//   void loop() { …  EEPROM.write(0, speed); }
//
// A byte of an ATmega's EEPROM lasts for 100,000 writes (ATmega328P, DS40002061B, 8.4: "an endurance of at
// least 100,000 write/erase cycles"). A sketch that writes in each pass of loop() reaches this number in six
// minutes, since a write takes 3.4 ms. The wear goes unnoticed on the bench. Weeks later the robot has lost
// its settings, and cannot store new ones.
//
// A finding is the first byte that, since the last power-on,
//
//   - was written 10 times, over at least a second, with the value that it already had, or
//   - was written 20 times, over at least five seconds, so often that it would wear out within a day.
//
// Sketches that save when a button is pressed, or by update() when a value has changed, are not reported. To
// fix a finding, use EEPROM.update(), since it writes only changed bytes. Or save rarely, or rotate over
// several bytes.
//
// Not detected: wear from years of rare writes; writes of earlier runs; wear of other memories such as flash.
// If two lines write the same byte, the finding names the line that exceeded the limit.
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
    double lasts_s() const;  ///< time until the byte is worn out at this rate
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
