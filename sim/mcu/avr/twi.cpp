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
  const bool comes = state_.master.step() != TwiMaster::Step::none && core_.cpu.data[control_] & kTwie;
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
  if (address == data_) return write_data(value);
  core_.at(status_) = value & kTwpsMask;
}

void Twi::write_data(std::uint8_t value) {
  std::uint8_t& control = core_.at(control_);
  if (control & kTwint) {
    core_.at(data_) = value;
    control &= static_cast<std::uint8_t>(~kTwwc);
  } else {
    control |= kTwwc;
  }
}

void Twi::write_control(std::uint8_t value) {
  std::uint8_t& control = core_.at(control_);
  const auto kept = static_cast<std::uint8_t>(control & (kTwwc | (value & kTwint ? 0 : kTwint)));
  control = static_cast<std::uint8_t>((value & (kTwea | kTwsta | kTwsto | kTwen | kTwie)) | kept);
  if (!(value & kTwen)) {
    const bool runs = state_.runs, takes_pins = state_.takes_pins;
    state_ = {};
    state_.runs = runs;
    state_.takes_pins = takes_pins;
    core_.events.cancel(done_);
  } else if (!(control & kTwint) && state_.master.step() == TwiMaster::Step::none) {
    if (state_.master.begin(control) != TwiMaster::Step::none) schedule(core_.now());
  }
  drive();
  request();
}

void Twi::schedule(Cycle at) {
  const auto bit = twi_bit(core_.cpu.data[rate_], core_.cpu.data[status_]);
  core_.schedule(done_, at + static_cast<Cycle>(state_.master.bits() * bit));
}

void Twi::done(Cycle at) {
  std::uint8_t& control = core_.at(control_);
  if (state_.master.end(core_.environment, control, core_.at(data_), at)) {
    control |= kTwint;
    request();
  } else if (state_.master.step() != TwiMaster::Step::none) {
    schedule(at);
  }
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
