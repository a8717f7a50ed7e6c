// Models the EEPROM on the host (hal/board/avr_eeprom.h), for avr-libc's functions and for register
// accesses. A write continues in the background. The next call of avr-libc's functions waits for the end of
// the write. Sketches that access registers poll EEPE. EEMPE stays set for 64 cycles instead of 4,
// because two statements take more than 4 cycles on the host (watchdog.cpp).
#pragma once

#include <stdint.h>

#include "hal/board/avr_eeprom.h"
#include "hal/board/sim_time.h"
#include "hal/host/clock.h"

namespace robosim {
namespace host ROBOSIM_WITHIN {

class Eeprom {
 public:
  /// Reads EECR.
  uint8_t control() const { return eeprom_.read(control_, state.now); }
  void set_control(uint8_t value);
  /// Return the registers EEDR and EEAR. EEAR cannot be changed during a write.
  uint8_t data() const { return data_; }
  void set_data(uint8_t value) { data_ = value; }
  uint16_t address() const { return address_; }
  void set_address(uint16_t value);

  /// Read a byte, or start a write of the duration `takes`. Neither function waits for a previous write.
  uint8_t read(uint16_t address) const;
  void write(uint16_t address, uint8_t value, SimTime takes);
  /// Returns the time at which the last write ends.
  SimTime ready() const { return eeprom_.ready; }

  bool may_interrupt() const { return control_ & kEerie; }
  bool pending() const { return eeprom_.is_requested(control_, state.now); }
  SimTime next() const { return !may_interrupt() ? kNever : ready() > state.now ? ready() : state.now; }

 private:
  uint8_t control_ = 0, data_ = 0;
  uint16_t address_ = 0;
  avr::EepromControl<SimTime> eeprom_;
};

extern Eeprom eeprom;

}  // namespace ROBOSIM_WITHIN
}  // namespace robosim
