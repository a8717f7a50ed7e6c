#include "sim/mcu/avr/twi.h"

namespace robosim::avr {

Twi::Twi(Core& core, Pins& pins)
    : core_(core),
      pins_(pins),
      rate_(core.chip.twi.address),
      status_(static_cast<Address>(rate_ + 1)),
      data_(static_cast<Address>(rate_ + 3)),
      control_(static_cast<Address>(rate_ + 4)),
      data_pin_(pins.named(core.chip.twi.data)),
      clock_pin_(pins.named(core.chip.twi.clock)) {
  for (const Address address : {status_, data_, control_}) {
    core.cpu.on_read<&Twi::read>(address, this);
    core.cpu.on_write<&Twi::write>(address, this);
  }
  done_ = core.events.add<&Twi::done>(this);
  core.keep(state_);
}

void Twi::reset(Cycle) {
  state_ = {};
  core_.at(data_) = kTwdrAtReset;
  core_.at(static_cast<Address>(rate_ + 2)) = kTwarAtReset;
}

std::uint64_t Twi::may_interrupt() const {
  const bool comes = state_.master.runs() && core_.cpu.data[control_] & kTwie;
  return Interrupts::bit(core_.chip.twi.vector, comes);
}

void Twi::request() {
  const std::uint8_t control = core_.at(control_);
  core_.request(core_.chip.twi.vector, control & kTwint && control & kTwie);
}

std::uint8_t Twi::read(Address address) {
  if (!state_.runs) return 0;
  return address == status_ ? static_cast<std::uint8_t>(state_.master.status() | core_.at(status_))
                            : core_.at(address);
}

void Twi::write(Address address, std::uint8_t value) {
  if (!state_.runs) return;
  if (address == control_) return write_control(value);
  if (address == data_) return state_.master.write_data(core_.at(control_), core_.at(data_), value);
  core_.at(status_) = value & kTwps;
}

void Twi::write_control(std::uint8_t value) {
  if (state_.master.write_control(core_.at(control_), value)) schedule(core_.now());
  if (!state_.master.runs()) core_.events.cancel(done_);
  drive();
  request();
}

void Twi::schedule(Cycle at) {
  const auto bit = twi_bit(core_.cpu.data[rate_], core_.cpu.data[status_]);
  core_.schedule(done_, at + static_cast<Cycle>(state_.master.bits() * bit));
}

void Twi::done(Cycle at) {
  if (state_.master.end(core_.environment, core_.at(control_), core_.at(data_), at)) schedule(at);
  request();
}

void Twi::drive() {
  const bool on = core_.at(control_) & kTwen;
  if (on == state_.takes_pins) return;
  state_.takes_pins = on;
  for (const int pin : {data_pin_, clock_pin_}) {
    if (on) {
      pins_.take(pin, {}, true);
    } else {
      pins_.give_back(pin);
    }
  }
}

void Twi::clock_runs(bool runs, Cycle at) {
  state_.runs = runs;
  core_.hold_or_go_on(done_, state_.held, runs, at);
}

}  // namespace robosim::avr
