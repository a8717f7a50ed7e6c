// The two-wire serial interface as master on a bus that nobody else is on. Data sheet DS40002061B,
// chapter 21.
//
//   bit      T = 16 + 2 TWBR 4^TWPS cycles (21.5.2)
//   START    T         TWSR 0x08, repeated 0x10
//   byte     9 T       not acknowledged: address to write 0x20, to read 0x48; data 0x30
//   STOP     T         TWSTO reads 0 again; no TWINT
//
// Each step begins when 1 is written to TWINT, and TWINT, which requests the interrupt as long as it is set,
// is set when it is done; meanwhile TWSR reads 0xF8, and TWDR is not written (TWWC). While TWEN is set SDA
// and SCL are inputs, with the port's pull-ups.
#pragma once

#include <cstdint>

#include "sim/avr/pins.h"

namespace robosim::avr {

class Twi final : public Peripheral {
 public:
  Twi(Core& core, Pins& pins);

  void reset(Cycle at) override;
  void clock_runs(bool runs, Cycle at) override;
  std::uint64_t may_interrupt() const override;

 private:
  enum class Step : std::uint8_t { none, start, byte, stop, stop_and_start };

  struct State {
    std::uint8_t status = 0xF8, result = 0xF8;  ///< as TWSR has it, and at the end of the step
    Step step = Step::none;
    bool owns_bus = false;  ///< START was sent and STOP not yet
    bool takes_pins = false;
    bool runs = true;
    Core::Held held;
  };

  std::uint8_t read(Address address);
  void write(Address address, std::uint8_t value);
  void write_control(std::uint8_t value);
  void write_data(std::uint8_t value);
  void next_step();
  void begin(Step step, Cycle at);
  void done(Cycle at);
  void drive();
  void request();
  Cycle bit() const;

  Core& core_;
  Pins& pins_;
  Address rate_, status_, data_, control_;
  int data_pin_, clock_pin_;
  Events::Id done_ = 0;
  State state_;
};

}  // namespace robosim::avr
