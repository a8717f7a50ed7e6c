#include "hal/host/two_wire.h"

#include "hal/host/clock.h"
#include "hal/host/interrupts.h"

namespace robosim {
namespace host {

TwoWire two_wire;

void TwoWire::set_control(uint8_t value) {
  rare_used = true;
  if (master_.write_control(control_, value)) schedule(state.now);
}

void TwoWire::schedule(SimTime at) { due_ = at + cycles(master_.bits() * avr::twi_bit(rate_, prescaler_)); }

void TwoWire::sync() {
  while (master_.runs() && state.now >= due_) {
    const SimTime at = due_;
    if (master_.end(*board, control_, data_, at)) schedule(at);
  }
}

}  // namespace host
}  // namespace robosim
