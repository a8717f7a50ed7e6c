// Models the HD44780U, the controller of character displays (Hitachi data sheet ADE-207-272). A display part
// contains this controller, and calls write() on each falling edge of its input E (enable). E is wired to a
// pin, or to a port expander.
//
//   instruction or data   4 or 8 bits, by "function set"; with 4 bits, the high half first
//   busy                  1.52 ms after clear and home, 37 us after any other instruction (at 270 kHz);
//                         meanwhile, writes are lost
//   memory                80 characters: two lines of 40, at addresses 0x00 and 0x40
//
// Modelled: clear, home, entry mode with shift, display on and off, cursor and display shift, function set,
// set address, data. For user-defined characters (codes 0 to 7), the code is stored, not the picture. Not
// modelled: reading back, the appearance of the cursor, fonts.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "hal/board/sim_time.h"

namespace robosim::robot {

/// A display controller, as a copyable value.
class Hd44780 {
 public:
  /// Handles the falling edge of E at `t`; `lines` are DB0 to DB7, of which a 4-bit wiring uses the upper
  /// four.
  void write(bool is_data, std::uint8_t lines, SimTime t);

  /// Returns the visible text of a display of this size, without trailing spaces. Joins the lines with "|".
  /// Returns "" while the display is off.
  std::string text(int columns, int rows) const;
  /// Returns the time at which text() may last have changed.
  SimTime changed_at() const { return changed_at_; }
  /// Returns the number of writes that were lost while the controller was busy.
  int lost() const { return lost_; }

 private:
  void instruct(std::uint8_t code);
  void put(std::uint8_t character);
  void step(int by);

  static constexpr int kLine = 40;

  std::array<std::uint8_t, 2 * kLine> memory_ = blank();
  int address_ = 0;    // index in memory_
  int shift_ = 0;      // shift of the display, in columns
  bool wide_ = true;   // the interface has 8 bits, as at power-on
  bool half_ = false;  // the high half of a 4-bit transfer has arrived
  std::uint8_t high_ = 0;
  bool two_lines_ = false;
  bool on_ = false;
  bool increments_ = true, shifts_ = false;
  bool in_pictures_ = false;  // data is for the character generator
  SimTime busy_until_ = 0;
  SimTime changed_at_ = 0;
  int lost_ = 0;

  static constexpr std::array<std::uint8_t, 2 * kLine> blank() {
    std::array<std::uint8_t, 2 * kLine> spaces{};
    for (auto& c : spaces) c = ' ';
    return spaces;
  }
};

}  // namespace robosim::robot
