#include "sim/mcu/avr/high_speed_timer.h"

#include <algorithm>

namespace robosim::avr {
namespace {

// Offsets of registers from TCCR4A.
constexpr int kHigh = -1, kTccr4a = 0, kTccr4b = 1, kTccr4c = 2, kTccr4d = 3;
constexpr std::size_t kA = 0, kB = 1, kTop = 2, kD = 3;
constexpr std::uint8_t kClockMask = 0x0F, kPrescalerReset = 0x40, kModeMask = 0x03, kFast = 0,
                       kHighMask = 0x03;
constexpr std::uint8_t kPwmA = 0x02, kPwmB = 0x01, kPwmD = 0x01, kConnections = 0xF0, kShadows = 0xF0;
constexpr std::uint16_t kTopAtReset = 0xFF, kMax = 0x3FF;

constexpr std::array<std::size_t, 3> kOutputOf{kA, kB, kD};  // index: the counter's channel
constexpr std::size_t channel_of(std::size_t output) { return output == kD ? 2 : output; }

// Maps counter events to bits of TIFR4 and TIMSK4 (15.12.8, 15.12.9), in vector order.
struct Flag {
  std::uint8_t hit, bit;
};
constexpr std::array<Flag, 4> kFlags{{{Counter::kMatchA, 0x40},
                                      {Counter::kMatchB, 0x20},
                                      {Counter::kMatchC, 0x80},
                                      {Counter::kOverflow, 0x04}}};

std::uint8_t in_register(std::uint8_t hits) {
  unsigned bits = 0;
  for (const Flag& flag : kFlags) bits |= hits & flag.hit ? flag.bit : 0u;
  return static_cast<std::uint8_t>(bits);
}

std::uint8_t of_register(std::uint8_t bits) {
  unsigned hits = 0;
  for (const Flag& flag : kFlags) hits |= bits & flag.bit ? flag.hit : 0u;
  return static_cast<std::uint8_t>(hits);
}

}  // namespace

HighSpeedTimer::HighSpeedTimer(Core& core, Pins& pins, int index)
    : core_(core), pins_(pins), spec_(core.chip.timers[index]) {
  output_pins_.fill(-1);
  for (int pin = 0; pin < core.chip.pin_count; ++pin)
    if (core.chip.pins[pin].timer == index) output_pins_[core.chip.pins[pin].output] = pin;
  for (const int pin : output_pins_)
    if (pin >= 0) pins.add_wave<&HighSpeedTimer::wave_level, &HighSpeedTimer::wave_heard>(pin, this);
  Cpu& cpu = core.cpu;
  for (int offset = kTccr4a; offset <= kTccr4d; ++offset)
    cpu.on_write<&HighSpeedTimer::write>(static_cast<Address>(spec_.control + static_cast<unsigned>(offset)),
                                         this);
  for (unsigned output = 0; output < kOutputs; ++output)
    cpu.on_write<&HighSpeedTimer::write_compare>(static_cast<Address>(spec_.compare[0] + output), this);
  cpu.on_read<&HighSpeedTimer::read_count>(spec_.count, this);
  cpu.on_write<&HighSpeedTimer::write_count>(spec_.count, this);
  cpu.on_read<&HighSpeedTimer::read_flags>(spec_.flags, this);
  cpu.on_write<&HighSpeedTimer::write_flags>(spec_.flags, this);
  cpu.on_write_bit<&HighSpeedTimer::write_flag>(spec_.flags, this);
  cpu.on_write<&HighSpeedTimer::write_enables>(spec_.enables, this);
  for (const Flag& flag : kFlags)
    core.interrupts.on_entry<&HighSpeedTimer::entered>(vector_of(flag.hit), this);
  due_ = core.events.add<&HighSpeedTimer::due>(this);
  core.keep(state_);
}

void HighSpeedTimer::reset(Cycle at) {
  state_ = {};
  state_.at = state_.began = at;
  core_.events.cancel(due_);
  state_.compare[kTop] = kTopAtReset;
  core_.at(static_cast<Address>(spec_.compare[0] + kTop)) = kTopAtReset;
  state_.counter.set_capture(kTopAtReset);
  set_mode();
}

void HighSpeedTimer::clock_runs(bool runs, Cycle at) {
  if (runs) {
    state_.began += at - state_.at;
    state_.at = at;
  } else {
    count_to(at);
  }
  state_.runs = runs;
  state_.drives_stale = true;
  settle();
}

// --- registers

// Writes a control register. TCCR4C contains copies of the bits COM4A and COM4B.
void HighSpeedTimer::write(Address address, std::uint8_t value) {
  count_to(core_.now());
  if (!state_.runs) return;
  core_.at(address) = value;
  const auto a = static_cast<Address>(spec_.control), b = static_cast<Address>(a + kTccr4b),
             c = static_cast<Address>(a + kTccr4c);
  const auto with = [](std::uint8_t to, std::uint8_t from) {
    return static_cast<std::uint8_t>((to & ~kConnections) | (from & kShadows));
  };
  if (address == a) core_.at(c) = with(core_.at(c), value);
  if (address == c) core_.at(a) = with(core_.at(a), value);
  if (address == b) {
    if (value & kPrescalerReset) state_.began = core_.now();
    core_.at(b) = static_cast<std::uint8_t>(value & ~kPrescalerReset);
  }
  set_mode();
  state_.drives_stale = true;
  settle();
}

std::uint16_t HighSpeedTimer::with_high(std::uint8_t low) const {
  return static_cast<std::uint16_t>((control(kHigh) & kHighMask) << 8 | low);
}

void HighSpeedTimer::write_compare(Address address, std::uint8_t value) {
  count_to(core_.now());
  if (!state_.runs) return;
  core_.at(address) = value;
  const auto output = static_cast<std::size_t>(address - spec_.compare[0]);
  const std::uint16_t compare = state_.compare[output] = with_high(value);
  if (output == kTop) {
    state_.counter.set_capture(compare);
  } else {
    state_.counter.write_compare(channel_of(output), compare);
    set_mode();
  }
  state_.drives_stale = true;
  settle();
}

std::uint8_t HighSpeedTimer::read_count(Address address) {
  if (!state_.runs) return 0;
  count_to(before_now());
  const std::uint16_t value = state_.counter.value();
  core_.at(static_cast<Address>(spec_.control - 1)) = static_cast<std::uint8_t>(value >> 8);
  return core_.at(address) = static_cast<std::uint8_t>(value);
}

void HighSpeedTimer::write_count(Address, std::uint8_t value) {
  count_to(core_.now());
  if (!state_.runs) return;
  state_.counter.set_value(with_high(value));
  settle();
}

std::uint8_t HighSpeedTimer::read_flags(Address address) {
  if (!state_.runs) return 0;
  count_to(before_now());
  return core_.at(address) = in_register(state_.flags);
}

void HighSpeedTimer::write_flags(Address, std::uint8_t value) {
  count_to(before_now());
  if (!state_.runs) return;
  state_.flags &= static_cast<std::uint8_t>(~of_register(value));
  settle();
}

void HighSpeedTimer::write_flag(Address address, std::uint8_t value, std::uint8_t bit) {
  write_flags(address, value & bit);
}

void HighSpeedTimer::write_enables(Address address, std::uint8_t value) {
  count_to(core_.now());
  if (!state_.runs) return;
  state_.enables = of_register(value);
  core_.at(address) = in_register(state_.enables);
  settle();
}

int HighSpeedTimer::connection(std::size_t output) const {
  switch (output) {
    case kA:
      return control(kTccr4a) >> 6 & 3;
    case kB:
      return control(kTccr4a) >> 4 & 3;
    case kD:
      return control(kTccr4c) >> 2 & 3;
    default:
      return 0;
  }
}

bool HighSpeedTimer::has_pwm(std::size_t output) const {
  return output == kA   ? control(kTccr4a) & kPwmA
         : output == kB ? control(kTccr4a) & kPwmB
                        : control(kTccr4c) & kPwmD;
}

// --- counting

int HighSpeedTimer::shift() const { return (control(kTccr4b) & kClockMask) - 1; }

Cycle HighSpeedTimer::tick_after(Cycle at, Cycle ticks) const {
  if (ticks == kNoCycle) return kNoCycle;
  return state_.began + ((((at - state_.began) >> shift()) + ticks) << shift());
}

// Sets the counting mode. Without PWM, a brief switch to normal mode makes values written to OCR4x effective
// at once.
void HighSpeedTimer::set_mode() {
  Counting how{Counting::Kind::pwm, false, Counting::Top::capture};
  if (!has_pwm(kA) && !has_pwm(kB) && !has_pwm(kD)) {
    state_.counter.count({Counting::Kind::normal, false, Counting::Top::capture}, kMax, kChannels);
  } else {
    how.dual_slope = how.frequency_correct = (control(kTccr4d) & kModeMask) != kFast;
  }
  state_.counter.count(how, kMax, kChannels);
}

void HighSpeedTimer::count_to(Cycle to) {
  if (!state_.runs || to <= state_.at) return;
  if (ticks_come()) {
    const Cycle ticks = ((to - state_.began) >> shift()) - ((state_.at - state_.began) >> shift());
    const std::uint8_t hits = ticks > 0 ? state_.counter.advance(ticks) : std::uint8_t{0};
    for (std::size_t channel = 0; channel < kChannels; ++channel)
      if (hits & Counter::kMatch[channel]) match(kOutputOf[channel]);
    state_.flags |= of_register(in_register(hits));
  }
  state_.at = to;
}

int HighSpeedTimer::vector_of(std::uint8_t flag) const {
  const auto place =
      std::find_if(kFlags.begin(), kFlags.end(), [&](const Flag& other) { return other.hit == flag; });
  return spec_.vector + static_cast<int>(place - kFlags.begin());
}

std::uint64_t HighSpeedTimer::may_interrupt() const {
  std::uint64_t vectors = 0;
  for (const Flag& flag : kFlags)
    vectors |= Interrupts::bit(vector_of(flag.hit), state_.enables & flag.hit && ticks_come());
  return vectors;
}

void HighSpeedTimer::request(unsigned flags) {
  state_.requested |= static_cast<std::uint8_t>(flags);
  for (const Flag& flag : kFlags)
    if (flags & flag.hit) core_.request(vector_of(flag.hit), true);
}

// Requests an interrupt in the cycle of the tick that sets the interrupt's flag. Reads of registers return
// the new flag only in later cycles.
void HighSpeedTimer::due(Cycle at) {
  count_to(at - 1);
  const bool ticks = ticks_come() && tick_after(state_.at, 1) == at;
  request((state_.flags | (ticks ? state_.counter.next_hits() : 0)) & state_.enables & ~state_.requested);
  tell();
  schedule();
}

void HighSpeedTimer::entered(int vector) {
  count_to(core_.now());
  state_.flags &= static_cast<std::uint8_t>(~kFlags[static_cast<std::size_t>(vector - spec_.vector)].hit);
  settle();
}

// Returns the events that pins and their listeners need. Enabled interrupts may need further events.
std::uint8_t HighSpeedTimer::wanted() const {
  unsigned wanted = 0;
  for (std::size_t output = 0; output < kOutputs; ++output) {
    const std::uint8_t match = Counter::kMatch[channel_of(output) % kChannels];
    const int com = connection(output);
    if (switches(output) && (com == 1 || state_.level[output] != (com == 3))) wanted |= match;
    if (state_.heard >> output & 1 && state_.taken[output]) wanted |= match | Counter::kOverflow;
  }
  return static_cast<std::uint8_t>(wanted);
}

void HighSpeedTimer::settle() {
  const auto served = static_cast<std::uint8_t>(state_.flags & state_.enables);
  for (const Flag& flag : kFlags)
    if (state_.requested & ~served & flag.hit) core_.request(vector_of(flag.hit), false);
  state_.requested &= served;
  request(served & ~state_.requested);
  tell();
  schedule();
}

void HighSpeedTimer::schedule() {
  Cycle next = kNoCycle;
  if (ticks_come()) {
    const auto unseen = static_cast<std::uint8_t>(state_.enables & ~state_.flags & ~state_.requested);
    if (unseen) next = tick_after(state_.at, state_.counter.ticks_to(unseen));
    if (const std::uint8_t hits = wanted())
      if (const Cycle tick = tick_after(state_.at, state_.counter.ticks_to(hits)); tick != kNoCycle)
        next = std::min(next, tick + 1);
  }
  if (next == kNoCycle) {
    core_.events.cancel(due_);
  } else {
    core_.schedule(due_, next);
  }
}

// --- pins

/// Returns whether an output drives its pin without PWM, so that a match can change the pin's level.
bool HighSpeedTimer::switches(std::size_t output) const {
  return output_pins_[output] >= 0 && connection(output) != 0 && !has_pwm(output);
}

void HighSpeedTimer::match(std::size_t output) {
  if (!switches(output)) return;
  bool& level = state_.level[output];
  const bool before = level;
  level = connection(output) == 1 ? !level : connection(output) == 3;
  if (level != before) state_.drives_stale = true;
}

bool HighSpeedTimer::pwm_level(std::size_t output) const {
  const Counter& counter = state_.counter;
  const std::uint16_t compare = counter.compare(channel_of(output)), value = counter.value();
  bool high = compare >= counter.top() || value < compare || (value == compare && !counter.counts_down());
  if (counter.how().dual_slope && compare == 0) high = false;
  return high != (connection(output) == 3);
}

std::size_t HighSpeedTimer::output_of(int pin) const {
  return static_cast<std::size_t>(std::find(output_pins_.begin(), output_pins_.end(), pin) -
                                  output_pins_.begin());
}

bool HighSpeedTimer::wave_level(int pin) {
  count_to(before_now());
  return pwm_level(output_of(pin));
}

void HighSpeedTimer::wave_heard(int pin, bool heard) {
  const auto bit = static_cast<std::uint8_t>(1u << output_of(pin));
  count_to(before_now());
  state_.heard = static_cast<std::uint8_t>(heard ? state_.heard | bit : state_.heard & ~bit);
  settle();
}

void HighSpeedTimer::tell() {
  if (state_.drives_stale) tell_drives();
  for (std::size_t output = 0; output < kOutputs; ++output)
    if (state_.heard >> output & 1 && state_.taken[output] && has_pwm(output))
      pins_.wave_edge(output_pins_[output], pwm_level(output));
}

void HighSpeedTimer::tell_drives() {
  state_.drives_stale = false;
  const bool fast = (control(kTccr4d) & kModeMask) == kFast;
  const int top = std::max<int>(state_.compare[kTop], 1);
  for (std::size_t output = 0; output < kOutputs; ++output) {
    const int pin = output_pins_[output], com = connection(output);
    if (pin < 0) continue;
    if (com == 0 || (has_pwm(output) && !ticks_come())) {
      if (state_.taken[output]) pins_.give_back(pin);
      state_.taken[output] = false;
      continue;
    }
    PinDrive drive = PinDrive::constant(state_.level[output]);
    if (has_pwm(output)) {
      const int value = std::min<int>(state_.compare[output], top);
      const double high = fast ? (value + 1.0) / (top + 1.0) : static_cast<double>(value) / top;
      drive = {PinMode::output, false, true, com == 3 ? 1.0 - high : high};
    }
    pins_.take(pin, drive);
    state_.taken[output] = true;
  }
}

}  // namespace robosim::avr
