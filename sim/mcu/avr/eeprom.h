// Models the EEPROM (data sheet DS40002061B, 8.4 and 8.6).
//
//   read    set EERE: EEDR contains the byte at once; the processor halts for 4 cycles
//   write   set EEMPE, then EEPE within 4 cycles: the processor halts for 2 cycles; EEPE reads 1 until the
//           end of the write
//
//   EEPM   0 erase and write, 3.4 ms      new value: EEDR
//          1 erase only, 1.8 ms           new value: 0xFF
//          2 write only, 1.8 ms           new value: old value AND EEDR
//
// During a write, EEAR and EEPM cannot change, and the EEPROM cannot be read. While EERIE is set and no write
// is in progress, the EEPROM requests the interrupt EE_READY. A write continues through sleep and resets. The
// duration of a write does not depend on CLKPR.
#pragma once

#include <cstdint>

#include "sim/mcu/avr/core.h"

namespace robosim::avr {

class Eeprom final : public Peripheral {
 public:
  explicit Eeprom(Core& core);

  void reset(Cycle at) override;
  std::uint64_t may_interrupt() const override;

 private:
  struct State {
    Cycle unlocked_until = 0;  ///< EEMPE reads 1 up to this cycle
    Cycle done_at = kNoCycle;
    std::uint8_t mode = 0;  ///< EEPM of the write in progress
    bool writing = false;
  };

  std::uint8_t read_control(Address address);
  ReadForecast forecast_of_control(Address at, std::uint8_t bits);
  void write_control(Address address, std::uint8_t value);
  void write_control_bit(Address address, std::uint8_t value, std::uint8_t bit);
  void control(std::uint8_t value, std::uint8_t written);
  void write_address(Address address, std::uint8_t value);
  void begin();
  void done(Cycle at);
  void clock_changed(std::int64_t hz_before);
  void request();
  std::uint16_t address() const;
  Address data_register() const { return static_cast<Address>(control_ + 1); }
  Address address_register() const { return static_cast<Address>(control_ + 2); }

  Core& core_;
  const Address control_;  ///< EECR
  Events::Id done_ = 0;
  State state_;
};

}  // namespace robosim::avr
