// Models the two-wire interface as master on the host. hal/board/avr_twi.h has the steps and their durations.
// Unlike on the chip, the port's registers drive SDA and SCL even while the interface is on.
#pragma once

#include <stdint.h>

#include "hal/board/avr_twi.h"
#include "hal/host/chip.h"

namespace robosim {
namespace host {

class TwoWire {
 public:
  uint8_t rate() const { return rate_; }
  void set_rate(uint8_t value) { rate_ = value; }
  /// Reads the register TWSR.
  uint8_t status() const { return static_cast<uint8_t>(master_.status() | prescaler_); }
  void set_status(uint8_t value) { prescaler_ = value & kTwps; }
  uint8_t address() const { return address_; }
  void set_address(uint8_t value) { address_ = value; }
  uint8_t data() const { return data_; }
  void set_data(uint8_t value) { master_.write_data(control_, data_, value); }
  uint8_t control() const { return control_; }
  void set_control(uint8_t value);

  /// Ends the current step if it is due.
  void sync();
  bool pending() const { return control_ & kTwint && control_ & kTwie; }
  bool may_interrupt() const { return control_ & kTwie && (master_.runs() || pending()); }
  SimTime next() const { return master_.runs() && control_ & kTwie ? due_ : kNever; }

 private:
  void schedule(SimTime at);

  avr::TwiMaster master_;
  uint8_t rate_ = 0, prescaler_ = 0, address_ = avr::kTwarAtReset, data_ = avr::kTwdrAtReset, control_ = 0;
  SimTime due_ = 0;
};

extern TwoWire two_wire;

}  // namespace host
}  // namespace robosim
