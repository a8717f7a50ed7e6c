// Models the EEPROM (data sheet DS40002061B, 8.4 and 8.6). hal/board/avr_eeprom.h describes its control
// register. After EEMPE is set, firmware can start a write within 4 cycles. A read halts the processor for 4
// cycles, a write for 2. A write continues through sleep and resets. The duration of a write does not depend
// on CLKPR.
#pragma once

#include <cstdint>

#include "hal/board/avr_eeprom.h"
#include "sim/mcu/avr/core.h"

namespace robosim::avr {

class Eeprom final : public Peripheral {
 public:
  explicit Eeprom(Core& core);

  void reset(Cycle at) override;
  std::uint64_t may_interrupt() const override;

 private:
  struct State {
    EepromControl<Cycle> control;
    std::uint8_t mode = 0;  ///< EEPM of the write in progress
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
  bool is_writing() const { return state_.control.is_writing(core_.now()); }
  Address data_register() const { return static_cast<Address>(control_ + 1); }
  Address address_register() const { return static_cast<Address>(control_ + 2); }

  Core& core_;
  const Address control_;  ///< EECR
  Events::Id done_ = 0;
  State state_;
};

}  // namespace robosim::avr
