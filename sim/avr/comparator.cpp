#include "sim/avr/comparator.h"

#include "hal/board/avr_adc.h"

namespace robosim::avr {
namespace {

constexpr std::uint8_t kAcd = 0x80, kAcbg = 0x40, kAco = 0x20, kAci = 0x10, kAcie = 0x08, kAcisMask = 0x03;
constexpr std::uint8_t kAcisAny = 0, kAcisFalling = 2, kAcisRising = 3;
constexpr std::uint8_t kAcme = 0x40, kAdcEnabled = 0x80, kMuxMask = 0x07;
constexpr Cycle kLookEvery = 64;

}  // namespace

Comparator::Comparator(Core& core, Pins& pins)
    : core_(core),
      pins_(pins),
      control_(core.chip.comparator.address),
      positive_(pins.named(core.chip.comparator.positive)),
      negative_(pins.named(core.chip.comparator.negative)) {
  core.cpu.on_read<&Comparator::read>(control_, this);
  core.cpu.on_write<&Comparator::write>(control_, this);
  core.interrupts.on_entry<&Comparator::entered>(core.chip.comparator.vector, this);
  core.triggers.offer<&Comparator::awaited>(core.chip.comparator.vector, this);
  look_ = core.events.add<&Comparator::look_again>(this);
  core.keep(state_);
}

void Comparator::reset(Cycle) { state_ = {}; }

double Comparator::volts_at(int pin) { return pin >= 0 && pins_.level(pin) ? core_.supply_volts : 0.0; }

double Comparator::negative_volts(Cycle at) {
  const std::uint8_t control_b = core_.at(core_.chip.at.adc_control_b);
  if (!(control_b & kAcme) || core_.at(core_.chip.at.adc_control) & kAdcEnabled) return volts_at(negative_);
  const AdcSpec& adc = core_.chip.adc;
  const int channel =
      adc_channel(adc, adc_selection(adc, core_.at(core_.chip.at.adc_multiplexer) & kMuxMask, control_b));
  return channel >= 0 ? core_.outside.volts(channel, at) : 0.0;
}

void Comparator::look(Cycle at) {
  std::uint8_t& control = core_.at(control_);
  if (control & kAcd || !state_.runs) return;
  const double positive = control & kAcbg ? core_.chip.adc.bandgap_volts : volts_at(positive_);
  const bool output = positive > negative_volts(at);
  if (output == state_.output) return;
  state_.output = output;
  const int sense = control & kAcisMask;
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

void Comparator::watch_or_not() {
  const std::uint8_t control = core_.at(control_);
  const bool watches = !(control & kAcd) && (control & kAcie || state_.awaited);
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
  core_.at(address) = static_cast<std::uint8_t>((value & ~(kAco | kAci)) | flag);
  watch_or_not();
  request();
}

void Comparator::clock_runs(bool runs, Cycle at) {
  state_.runs = runs;
  core_.hold_or_go_on(look_, state_.held, runs, at);
}

}  // namespace robosim::avr
