// Models the control register of an AVR's watchdog (ATmega328P, data sheet DS40002061B, 11.8 and 11.9.2), for
// the target host and for the emulated chip.
//
//   timeout     (2048 << WDP) cycles of 128 kHz after WDR, or after the last timeout: 16 ms to 8 s
//
//   WDE  WDIE   (WDTON is not programmed)
//   0    0      stopped
//   0    1      each timeout sets WDIF
//   1    0      a timeout resets the chip, with WDRF in MCUSR
//   1    1      a timeout sets WDIF; entering the vector clears WDIE. The next timeout then resets the chip.
//               A timeout before the vector is entered also resets the chip
//
// Firmware can clear WDE and change WDP only in a short window after setting WDCE and WDE together. Firmware
// can set WDE, and change WDIE, at any time. While WDRF is set, WDE stays set.
#pragma once

#include "hal/board/avr_registers.h"

namespace robosim {
namespace avr {

/// Returns WDP. Reserved values count as the longest timeout.
constexpr int watchdog_power(uint8_t control) {
  return control & kWdp3 ? 8 + ((control & 7) != 0) : control & 7;
}

/// `Time` is the type of the caller's times. The caller stores WDTCSR without WDCE as `control`.
template <typename Time>
struct WatchdogControl {
  Time origin = 0;          ///< when the present timeout period began
  Time unlocked_until = 0;  ///< WDCE reads 1 up to this time

  uint8_t read(uint8_t control, Time now) const {
    return static_cast<uint8_t>(control | (now <= unlocked_until ? kWdce : 0));
  }
  /// Writes WDTCSR. `held` means that WDRF is set. A write of WDCE opens the window for the time `window`.
  void write(uint8_t& control, uint8_t value, bool held, Time now, Time window) {
    constexpr int kGuarded = kWde | kWdp;
    const uint8_t before = control;
    const int guarded = now <= unlocked_until ? value & kGuarded : (before & kGuarded) | (value & kWde);
    control = static_cast<uint8_t>((before & kWdif & ~value) | (value & kWdie) | guarded | (held ? kWde : 0));
    unlocked_until = value & kWdce && value & kWde ? now + window : 0;
    if (!(before & (kWde | kWdie))) origin = now;
  }
  /// Returns the time of the next timeout after `now`, if the watchdog is on.
  Time next(Time now, Time period) const { return origin + ((now - origin) / period + 1) * period; }
  /// Handles a timeout. Returns true if the timeout resets the chip.
  static bool times_out(uint8_t& control) {
    if (control & kWde && (control & (kWdie | kWdif)) != kWdie) return true;
    control |= kWdif;
    return false;
  }
  static void enter(uint8_t& control) {
    control &= static_cast<uint8_t>(~(control & kWde ? kWdif | kWdie : kWdif));
  }
};

}  // namespace avr
}  // namespace robosim
