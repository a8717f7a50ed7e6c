#include "sim/mcu/avr/comparator.h"

#include "hal/board/avr_adc.h"
#include "sim/mcu/avr/timer.h"

namespace robosim::avr {
namespace {

constexpr std::uint8_t kAcisAny = 0, kAcisFalling = 2, kAcisRising = 3;
constexpr std::uint8_t kMuxMask = 0x07, kHighChannels = 8;
constexpr Cycle kLookEvery = 64;

}  // namespace

Comparator::Comparator(Core& core, Pins& pins, Timer* captures)
    : core_(core),
      pins_(pins),
      captures_(captures),
      control_(core.chip.comparator.address),
      positive_(pins.named(core.chip.comparator.positive)),
      negative_(pins.named(core.chip.comparator.negative)) {
  core.cpu.on_read<&Comparator::read>(control_, this);
  core.cpu.on_write<&Comparator::write>(control_, this);
  core.cpu.on_write_bit<&Comparator::write_bit>(control_, this);
  core.interrupts.on_entry<&Comparator::entered>(core.chip.comparator.vector, this);
  core.triggers.offer<&Comparator::awaited>(core.chip.comparator.vector, this);
  if (positive_ >= 0) listeners_[0] = pins.add_listener<&Comparator::heard>(positive_, this);
  if (negative_ >= 0) listeners_[1] = pins.add_listener<&Comparator::heard>(negative_, this);
  look_ = core.events.add<&Comparator::look_again>(this);
  core.keep(state_);
}

void Comparator::reset(Cycle) { state_ = {}; }

bool Comparator::is_on() const { return !(core_.cpu.data[control_] & kAcd) && state_.runs; }

double Comparator::negative_volts(Cycle at) {
  const std::uint8_t control_b = core_.at(core_.chip.at.adc_control_b);
  if (!(control_b & kAcme) || core_.at(core_.chip.at.adc_control) & kAden)
    return negative_ >= 0 ? pins_.source(negative_, at).volts : core_.chip.adc.bandgap_volts;
  const int chosen = (core_.at(core_.chip.at.adc_multiplexer) & kMuxMask) +
                     (control_b & core_.chip.adc.high_channels ? kHighChannels : 0);
  return pins_.source(pins_.analog(chosen & (core_.chip.comparator.channels - 1)), at).volts;
}

void Comparator::look(Cycle at) {
  if (!is_on()) return;
  std::uint8_t& control = core_.at(control_);
  const double positive = control & kAcbg ? core_.chip.adc.bandgap_volts : pins_.source(positive_, at).volts;
  const bool output = positive > negative_volts(at);
  if (output == state_.output) return;
  state_.output = output;
  if (captures_) captures_->comparator_changed(output, at);
  const int sense = control & kAcis;
  if (sense != kAcisAny && sense != (output ? kAcisRising : kAcisFalling)) return;
  const bool rises = !(control & kAci);
  control |= kAci;
  request();
  if (rises) core_.triggers.raised(core_.chip.comparator.vector, at);
}

void Comparator::look_again(Cycle at) {
  look(at);
  core_.schedule(look_, at + kLookEvery);
}

void Comparator::heard(int, bool, Cycle at) { look(at); }

void Comparator::watch_or_not() {
  const std::uint8_t control = core_.at(control_);
  const bool watches = is_on() && (control & (kAcie | kAcic) || state_.awaited);
  if (watches == (core_.events.due(look_) != kNoCycle)) return;
  core_.schedule(look_, watches ? core_.now() + kLookEvery : kNoCycle);
}

bool Comparator::awaited(int, bool is) {
  state_.awaited = is;
  watch_or_not();
  return core_.at(control_) & kAci;
}

std::uint64_t Comparator::may_interrupt() const {
  const std::uint8_t control = core_.cpu.data[control_];
  return Interrupts::bit(core_.chip.comparator.vector, !(control & kAcd) && control & kAcie);
}

void Comparator::request() {
  const std::uint8_t control = core_.at(control_);
  core_.request(core_.chip.comparator.vector, control & kAci && control & kAcie);
}

void Comparator::entered(int) {
  core_.at(control_) &= static_cast<std::uint8_t>(~kAci);
  request();
}

std::uint8_t Comparator::read(Address address) {
  look(core_.now());
  return static_cast<std::uint8_t>(core_.at(address) | (state_.output ? kAco : 0));
}

void Comparator::write(Address address, std::uint8_t value) {
  look(core_.now());
  const auto flag = static_cast<std::uint8_t>(core_.at(address) & kAci & ~value);
  const int kept = ~(kAco | kAci | (captures_ ? 0 : kAcic));
  core_.at(address) = static_cast<std::uint8_t>((value & kept) | flag);
  for (const int listener : listeners_)
    if (listener >= 0) pins_.listen(listener, is_on());
  if (captures_) captures_->capture_comparator(value & kAcic, state_.output, core_.now());
  look(core_.now());
  watch_or_not();
  request();
}

// Handles SBI and CBI, which can address ACSR on an ATtiny85. If SBI or CBI changes another bit, ACI is not
// cleared (ATtiny85 data sheet 2586Q, notes on the register summary).
void Comparator::write_bit(Address address, std::uint8_t value, std::uint8_t bit) {
  write(address, bit == kAci ? value : static_cast<std::uint8_t>(value & ~kAci));
}

void Comparator::clock_runs(bool runs, Cycle at) {
  state_.runs = runs;
  core_.hold_or_go_on(look_, state_.held, runs, at);
}

}  // namespace robosim::avr
