// Models the control register of an AVR's EEPROM (ATmega328P, data sheet DS40002061B, 8.4 and 8.6), for the
// target host and for the emulated chip.
//
//   read    set EERE: EEDR contains the byte at once
//   write   set EEMPE, and within a short window EEPE, which then reads 1 until the write ends
//
//   EEPM   0 erase and write, 3.4 ms      new value: EEDR
//          1 erase only, 1.8 ms           new value: 0xFF
//          2 write only, 1.8 ms           new value: old value AND EEDR
//
// During a write, EEAR and EEPM cannot change, and the EEPROM cannot be read. While EERIE is set and no write
// is in progress, the EEPROM requests the interrupt EE_READY.
#pragma once

#include "hal/board/avr_registers.h"
#include "hal/board/board.h"

namespace robosim {
namespace avr {

/// `Time` is the type of the caller's times. The caller stores EECR without EEMPE and EEPE as `control`.
template <typename Time>
struct EepromControl {
  Time ready = 0;           ///< when the last write ends
  Time unlocked_until = 0;  ///< EEMPE reads 1 up to this time

  bool is_writing(Time now) const { return now < ready; }
  bool is_requested(uint8_t control, Time now) const { return control & kEerie && !is_writing(now); }
  uint8_t read(uint8_t control, Time now) const {
    return static_cast<uint8_t>(control | (now <= unlocked_until ? kEempe : 0) |
                                (is_writing(now) ? kEepe : 0));
  }
  /// Writes the bits `written` of EECR. A write of EEMPE opens the window for the time `window`. The result
  /// contains EERE if the caller must read a byte, and EEPE if the caller must write one.
  int write(uint8_t& control, uint8_t value, uint8_t written, Time now, Time window) {
    const bool unlocked = now <= unlocked_until;
    control = static_cast<uint8_t>((value & kEerie) | ((is_writing(now) ? control : value) & kEepm));
    if (written & kEempe) unlocked_until = value & kEempe ? now + window : 0;
    return is_writing(now) ? 0 : value & written & (unlocked ? kEere | kEepe : kEere);
  }
};

/// A write: the byte's new value, and the duration. A duration of 0 means that EEPM has the reserved value 3,
/// and nothing is written.
struct EepromWrite {
  uint8_t value;
  SimTime takes;  ///< ns
};
constexpr EepromWrite eeprom_write(uint8_t control, uint8_t old, uint8_t data) {
  return (control & kEepm) == 0x00   ? EepromWrite{data, kEepromWriteTime}
         : (control & kEepm) == 0x10 ? EepromWrite{0xFF, 1800 * kMicrosecond}
         : (control & kEepm) == 0x20 ? EepromWrite{static_cast<uint8_t>(old & data), 1800 * kMicrosecond}
                                     : EepromWrite{old, 0};
}

}  // namespace avr
}  // namespace robosim
