// Models the two-wire serial interface as master: interrupt and pins. hal/board/avr_twi.h models its
// registers and the steps on the bus. While TWEN is set, SDA and SCL are inputs, with the port's pull-ups.
#pragma once

#include <cstdint>

#include "hal/board/avr_twi.h"
#include "sim/mcu/avr/pins.h"

namespace robosim::avr {

class Twi final : public Peripheral {
 public:
  Twi(Core& core, Pins& pins);

  void reset(Cycle at) override;
  void clock_runs(bool runs, Cycle at) override;
  std::uint64_t may_interrupt() const override;

 private:
  struct State {
    TwiMaster master;
    bool takes_pins = false;
    bool runs = true;
    Core::Held held;
  };

  std::uint8_t read(Address address);
  void write(Address address, std::uint8_t value);
  void write_control(std::uint8_t value);
  void schedule(Cycle at);
  void done(Cycle at);
  void drive();
  void request();

  Core& core_;
  Pins& pins_;
  Address rate_, status_, data_, control_;
  int data_pin_, clock_pin_;
  Events::Id done_ = 0;
  State state_;
};

}  // namespace robosim::avr
