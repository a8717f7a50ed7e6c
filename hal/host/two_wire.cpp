#include "hal/host/two_wire.h"

#include "hal/host/clock.h"
#include "hal/host/interrupts.h"

namespace robosim {
namespace host {

TwoWire two_wire;

void TwoWire::set_data(uint8_t value) {
  if (control_ & avr::kTwint) {
    data_ = value;
    control_ &= static_cast<uint8_t>(~avr::kTwwc);
  } else {
    control_ |= avr::kTwwc;
  }
}

void TwoWire::set_control(uint8_t value) {
  rare_used = true;
  const uint8_t kept = control_ & (avr::kTwwc | (value & avr::kTwint ? 0 : avr::kTwint));
  constexpr uint8_t kWritten = avr::kTwea | avr::kTwsta | avr::kTwsto | avr::kTwen | avr::kTwie;
  control_ = static_cast<uint8_t>((value & kWritten) | kept);
  if (!(value & avr::kTwen)) {
    master_ = avr::TwiMaster();
  } else if (!(control_ & avr::kTwint) && !runs()) {
    if (master_.begin(control_) != avr::TwiMaster::Step::none) schedule(state.now);
  }
}

void TwoWire::schedule(SimTime at) { due_ = at + cycles(master_.bits() * avr::twi_bit(rate_, prescaler_)); }

void TwoWire::sync() {
  while (runs() && state.now >= due_) {
    const SimTime at = due_;
    if (master_.end(*board, control_, data_, at)) {
      control_ |= avr::kTwint;
    } else if (runs()) {
      schedule(at);
    }
  }
}

}  // namespace host
}  // namespace robosim
