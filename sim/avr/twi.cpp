#include "sim/avr/twi.h"

namespace robosim::avr {
namespace {

// TWCR
constexpr std::uint8_t kTwint = 0x80, kTwea = 0x40, kTwsta = 0x20, kTwsto = 0x10, kTwwc = 0x08, kTwen = 0x04,
                       kTwie = 0x01;
constexpr std::uint8_t kTwpsMask = 0x03, kReads = 0x01;
// TWSR
constexpr std::uint8_t kStarted = 0x08, kStartedAgain = 0x10, kWriteNack = 0x20, kDataNack = 0x30,
                       kReadNack = 0x48;
constexpr std::uint8_t kNoState = 0xF8;
constexpr std::uint8_t kTwdrAtReset = 0xFF, kTwarAtReset = 0xFE;
constexpr Cycle kBitsOfByte = 9;

}  // namespace

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

Cycle Twi::bit() const {
  return 16 + 2 * (static_cast<Cycle>(core_.cpu.data[rate_]) << 2 * (core_.cpu.data[status_] & kTwpsMask));
}

std::uint64_t Twi::may_interrupt() const {
  const bool comes = state_.step != Step::none && core_.cpu.data[control_] & kTwie;
  return Interrupts::bit(core_.chip.twi.vector, comes);
}

void Twi::request() {
  const std::uint8_t control = core_.at(control_);
  core_.request(core_.chip.twi.vector, control & kTwint && control & kTwie);
}

std::uint8_t Twi::read(Address address) {
  if (!state_.runs) return 0;
  return address == status_ ? static_cast<std::uint8_t>(state_.status | core_.at(status_))
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
  } else if (!(control & kTwint) && state_.step == Step::none) {
    next_step();
  }
  drive();
  request();
}

void Twi::next_step() {
  const std::uint8_t control = core_.at(control_);
  const std::uint8_t before = state_.status;
  state_.status = kNoState;
  const Cycle now = core_.now();
  if (control & kTwsto) {
    begin(control & kTwsta ? Step::stop_and_start : Step::stop, now);
  } else if (control & kTwsta) {
    begin(Step::start, now);
  } else if (before == kStarted || before == kStartedAgain) {
    state_.result = core_.at(data_) & kReads ? kReadNack : kWriteNack;
    begin(Step::byte, now);
  } else if (before == kWriteNack || before == kDataNack) {
    state_.result = kDataNack;
    begin(Step::byte, now);
  }
}

void Twi::begin(Step step, Cycle at) {
  if (step == Step::start) state_.result = state_.owns_bus ? kStartedAgain : kStarted;
  state_.step = step;
  core_.schedule(done_, at + (step == Step::byte ? kBitsOfByte : 1) * bit());
}

void Twi::done(Cycle at) {
  const Step step = state_.step;
  state_.step = Step::none;
  std::uint8_t& control = core_.at(control_);
  if (step == Step::stop || step == Step::stop_and_start) {
    state_.owns_bus = false;
    control &= static_cast<std::uint8_t>(~kTwsto);
    if (step == Step::stop_and_start || control & kTwsta) begin(Step::start, at);
    return;
  }
  state_.owns_bus = true;
  state_.status = state_.result;
  control |= kTwint;
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
