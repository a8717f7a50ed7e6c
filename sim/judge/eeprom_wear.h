// EEPROM that wears out: a byte of it that is written again and again.
//
//   void loop() { …  EEPROM.write(0, speed); }
//
// A byte of an ATmega's EEPROM stands 100,000 writes (ATmega328P, DS40002061B, 8.4: "an endurance of at least
// 100,000 write/erase cycles"), then it keeps nothing. A sketch that writes in each pass of loop() is there
// in six minutes, for a write takes 3.4 ms. On the bench nothing is seen of it; weeks later the robot has
// lost its settings, and new ones do not help.
//
// What is found is the first byte that, since the last power-on,
//
//   was written 10 times, over a second or longer, with what it held already, or
//   was written 20 times, over five seconds or longer, so often that a day uses it up
//
// Who saves when a button is pressed, or by update() when something has changed, does neither. Mended by
// EEPROM.update(), which writes only what differs; by saving seldom; or by going round over several bytes.
//
// What it cannot see: what years of saving seldom come to, what earlier runs have written, other memories
// such as flash, and which of two lines is to blame that write the same byte (the one that made it too many
// is told).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "sim/exec/core/executor.h"

namespace robosim::judge {

class EepromWear {
 public:
  static constexpr const char* kName = "eeprom_wear";

  /// The firmware has started.
  void powered_on() { cells_.clear(); }
  /// `executor` is asked for the line where this write makes a finding.
  void written(std::uint16_t address, std::uint8_t before, std::uint8_t value, SimTime t,
               exec::Executor& executor);
  std::vector<exec::Detected> found() const;

 private:
  struct Cell {
    SimTime began = 0, last = 0;
    std::int64_t writes = 0, needless = 0;
    double lasts_s() const;  ///< until it is used up, if this goes on
  };
  struct Found {
    std::uint16_t address = 0;
    wire::SourceLine where;
    SimTime first = 0;
    Cell cell;
  };

  std::map<std::uint16_t, Cell> cells_;
  std::optional<Found> found_;
};

}  // namespace robosim::judge
